// SPDX-License-Identifier: MIT
#include "solver/solve.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"
#include "solver/touching.h"

namespace crumple::solver {
namespace {

// Below this the recursive residual of float arithmetic is noise: (6e-8)^2 and a little.
constexpr double noise_floor = 1e-13;

// Contacts that let go or begin to hold cost conjugate gradients what they have learned.
constexpr std::uint32_t iterations_between_checks = 4;

// The rigid part of the residual is taken out to float's precision. Once the rest has shrunk so far (of r.z), what was
// left of it would turn the directions, and the iterations would diverge; that they do is seen by how far they grew.
constexpr double falls_between_balances = 1e-3;
constexpr double grows_between_balances = 30;

// r.z since the last balance.
struct Course {
    double begun = 0;
    double least = 0;
    explicit Course(double rz) : begun(rz), least(rz) {}
    [[nodiscard]] bool wants_balance(double rz) {
        least = std::min(least, rz);
        return rz < falls_between_balances * begun || rz > grows_between_balances * least;
    }
};

class Loops {
public:
    Loops(const Model& model, Workspace& workspace, const Jobs& jobs)
        : model_(model), workspace_(workspace), jobs_(jobs) {}

    // The sum of body(begin, end) over pieces of the nodes, added in order.
    template <class Body>
    double sum(Body&& body) const {
        const std::span<double> sums = workspace_.sums;
        each([&](std::size_t piece, std::size_t begin, std::size_t end) { sums[piece] = body(begin, end); });
        double total = 0;
        for (std::size_t i = 0; i * nodes_per_piece < model_.node_count; ++i) total += sums[i];
        return total;
    }
    template <class Body>
    void each(Body&& body) const {
        for_pieces(jobs_, model_.node_count, nodes_per_piece, body);
    }

private:
    const Model& model_;
    Workspace& workspace_;
    const Jobs& jobs_;
};

// Partials are sorted by node: those of one piece.
std::span<const Partial> partials_between(std::span<const Partial> partials, std::size_t begin, std::size_t end) {
    const auto before = [](const Partial& p, std::size_t node) { return p.node < node; };
    const auto first = std::lower_bound(partials.begin(), partials.end(), begin, before);
    const auto last = std::lower_bound(first, partials.end(), end, before);
    return {first, last};
}

// Loops over whole vectors of nodes run past the last one, where the memory held other things before.
void clear_padding(const Model& model, Workspace& w) {
    for (std::size_t node = model.node_count; 4 * node < w.product.size(); ++node) {
        for (const auto rows : {w.precise, w.direction, w.product}) std::fill_n(&rows[4 * node], 4, 0.0f);
        for (const std::size_t column : {0, 16, 32}) std::fill_n(&w.inverse[inverse_at(node) + column], 4, 0.0f);
    }
}

void start_residual(const Model& model, Workspace& w) {
    std::copy(w.load.begin(), w.load.end(), w.residual.begin());
    std::fill(w.change.begin(), w.change.end(), 0.0f);
    for (std::size_t node = 0; node < model.node_count; ++node) {
        if (w.is_fixed[node]) std::fill_n(&w.residual[4 * node], 4, 0.0f);
    }
}

// One solve: the pieces conjugate gradients are made of.
class Solve {
public:
    Solve(const Model& model, Workspace& w, std::span<Partial> partials, const State& state, Whole& whole,
          const Kernels& kernels, const Jobs& jobs)
        : model_(model),
          w_(w),
          partials_(partials),
          state_(state),
          whole_(whole),
          kernels_(kernels),
          job_(solve_job(model, w)),
          jobs_(jobs),
          loops_(model, w, jobs) {
        has_contacts_ = std::any_of(partials.begin(), partials.end(), [](const Partial& p) { return p.is_contact; });
    }

    [[nodiscard]] bool has_contacts() const { return has_contacts_; }

    // The best point on the way from what the constraints ask of single nodes to what they ask of the whole. Returns
    // what there was to solve, b . P b.
    double begin() {
        clear_padding(model_, w_);
        start_residual(model_, w_);
        start_rigid(whole_.locks, model_, w_);
        if (whole_.response.is_given && !partials_.empty()) take_response();
        hold_touching(model_, state_, w_, partials_);
        const double first = precondition();
        prepare_modes();
        return first;
    }
    // z = P r and p = z, conjugate to the rigid motions. Returns r . z.
    double restart() {
        const double rz = precondition();
        turn_rigid(whole_.locks, 0);
        if (whole_.response.is_given) modes_.deflate(model_, state_, w_, partials_, whole_.locks, kernels_, jobs_);
        return rz;
    }
    // q = A p; returns p . q
    double multiply() {
        spread_rigid(whole_.locks, model_, w_);
        const double pq = loops_.sum([&](std::size_t b, std::size_t e) {
            kernels_.multiply(job_, b, e);
            for (const Partial& p : partials_between(partials_, b, e)) {
                keep_free_part(p, job_.product + 4 * static_cast<std::size_t>(p.node));
            }
            return kernels_.product_dot(job_, b, e);
        });
        return pq + gather_rigid(whole_.locks, model_, w_);
    }
    // dv += a p, r -= a q, z = P r; returns r . z
    double descend(double a) {
        descend_rigid(whole_.locks, a);
        return loops_.sum([&](std::size_t b, std::size_t e) {
            return kernels_.descend(job_, static_cast<float>(a), b, e);
        }) + precondition_rigid(whole_.locks);
    }
    // p = z + b p
    void turn(double b) {
        const auto beta = static_cast<float>(b);
        loops_.each([&](std::size_t, std::size_t begin, std::size_t end) { kernels_.turn(job_, beta, begin, end); });
        turn_rigid(whole_.locks, b);
        if (whole_.response.is_given) modes_.deflate(model_, state_, w_, partials_, whole_.locks, kernels_, jobs_);
    }
    bool recheck(Recheck what) {
        RigidModes* modes = whole_.response.is_given ? &modes_ : nullptr;
        if (!has_contacts_ || !recheck_contacts(model_, state_, w_, partials_, whole_.locks, modes, what)) return false;
        if (modes) modes_.refresh(model_, state_, w_, partials_, whole_.locks, kernels_, jobs_);
        balance_whole();
        return true;
    }
    // Says whether there is a whole.
    bool balance_whole() {
        if (whole_.response.is_given) modes_.balance(model_, state_, w_, partials_, whole_.locks);
        return whole_.response.is_given;
    }

private:
    // z = P r and p = z. Returns r . z.
    double precondition() {
        return loops_.sum([&](std::size_t b, std::size_t e) { return kernels_.start(job_, b, e); }) +
               precondition_rigid(whole_.locks);
    }
    void prepare_modes() {
        if (!whole_.response.is_given) return;
        modes_.prepare(model_, state_, w_, partials_, whole_.locks, kernels_, jobs_);
        balance_whole();
    }
    // Moves toward the rigid response as far as that is good.
    void take_response() {
        const RigidResponse& response = whole_.response;
        for (std::size_t node = 0; node < model_.node_count; ++node) {
            const Vec3f v = narrow(rigid_velocity(response.jump, widen(position(state_, node))));
            for (int i = 0; i < 3; ++i) w_.direction[4 * node + static_cast<std::size_t>(i)] = v[i];
        }
        for (const Partial& p : partials_) {
            const Vec3 v = widen(velocity(state_, p.node));
            const Vec3 d = response_velocity(response.motion, p, widen(position(state_, p.node)), v) - v;
            const Vec3 jump = rigid_velocity(response.jump, widen(position(state_, p.node)));
            const Vec3 n = widen(p.taken);
            const Vec3 kept = p.is_contact ? jump + n * dot(n, d - jump) : jump - widen(taken_part(p, narrow(jump)));
            for (int i = 0; i < 3; ++i) {
                w_.direction[4 * std::size_t{p.node} + static_cast<std::size_t>(i)] = static_cast<float>(kept[i]);
            }
        }
        whole_.locks.direction = response.jump;
        spread_rigid(whole_.locks, model_, w_);
        double along = 0;
        // Nothing is held while the way is measured: both of its ends are allowed.
        const double pq = loops_.sum([&](std::size_t b, std::size_t e) {
            kernels_.multiply(job_, b, e);
            return kernels_.product_dot(job_, b, e);
        });
        for (std::size_t i = 0; i < 4 * model_.node_count; ++i)
            along += static_cast<double>(w_.direction[i]) * w_.residual[i];
        const double stiffness = pq + gather_rigid(whole_.locks, model_, w_);
        if (whole_.locks.is_active) along += dot6(whole_.locks.direction, whole_.locks.residual);
        const double a = std::clamp(along / stiffness, 0.0, 1.0);
        if (!(stiffness > 0) || !std::isfinite(a)) return;
        (void)descend(a);
    }

    const Model& model_;
    Workspace& w_;
    std::span<Partial> partials_;
    const State& state_;
    Whole& whole_;
    const Kernels& kernels_;
    SolveJob job_;
    const Jobs& jobs_;
    Loops loops_;
    RigidModes modes_;
    bool has_contacts_ = false;
};

}

SolveJob solve_job(const Model& model, Workspace& w) {
    return {model.slices.node.data(), model.slices.start.data(), model.slices.column.data(),
            w.is_fixed.data(),        w.blocks.data(),           w.inverse.data(),
            w.change.data(),          w.residual.data(),         w.precise.data(),
            w.direction.data(),       w.product.data()};
}

Solved solve(const Model& model, Workspace& w, std::size_t partial_count, const Settings& settings, const State& state,
             Whole& whole, const Kernels& kernels, const Jobs& jobs) {
    Solve solve(model, w, w.partials.first(partial_count), state, whole, kernels, jobs);
    const double first = solve.begin();
    const double enough = first * std::max(settings.tolerance * settings.tolerance, noise_floor);
    Solved result;
    result.has_overflowed = !std::isfinite(first);
    double rz = result.has_overflowed ? first : solve.restart();
    const double begun = std::max(first, rz);
    Course course(rz);
    while (result.iterations < settings.max_iterations && rz > enough) {  // never entered when first is not finite
        const double pq = solve.multiply();
        const double a = rz / pq;
        if (!(pq > 0) || !std::isfinite(a)) {
            result.is_too_stiff = true;
            break;
        }
        const double next = solve.descend(a);
        ++result.iterations;
        const bool starts_anew = (result.iterations % iterations_between_checks == 0 && solve.recheck(Recheck::all)) ||
                                 (course.wants_balance(next) && solve.balance_whole());
        if (starts_anew) {
            rz = solve.restart();
            course = Course(rz);
            continue;
        }
        solve.turn(next / rz);
        rz = next;
    }
    if (result.has_overflowed) return result;
    (void)solve.recheck(Recheck::passed_only);
    solve.balance_whole();
    // A residual that grew tells the same: in exact arithmetic it ends below where it began.
    result.is_too_stiff = result.is_too_stiff || (rz > begun && !solve.has_contacts());
    result.residual = first > 0 ? static_cast<float>(std::sqrt(std::max(0.0, rz / first))) : 0;
    return result;
}

}
