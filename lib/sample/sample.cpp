// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/sample.h"

#include <algorithm>
#include <cmath>

#include "sample/cells.h"
#include "sample/count.h"
#include "sample/method.h"
#include "sample/space.h"
#include "sample/thin.h"

namespace crumple::sample {

namespace {

// Of space that points take up on average: 1 / (0.7 h^3) points a volume.
constexpr double volume_a_point = 0.7;

// 2^x for |x| <= 2 from square roots alone, which round the same on every machine.
double power_of_two(double x) {
    const double whole = std::floor(x);
    double rest = x - whole;
    double result = std::ldexp(1.0, static_cast<int>(whole));
    double root = 2;
    for (int bit = 0; bit < 16; ++bit) {
        root = std::sqrt(root);
        rest *= 2;
        if (rest >= 1) {
            result *= root;
            rest -= 1;
        }
    }
    return result;
}

// Density times 8^(2 green - 1) is size times 2^(1 - 2 green).
std::vector<double> painted_size_factors(const Shell& shell) {
    std::vector<double> factors;
    factors.reserve(shell.color.size());
    for (const auto& color : shell.color) {
        const double green = std::isfinite(color[1]) ? std::clamp<double>(color[1], 0, 1) : 0.5;
        factors.push_back(power_of_two(1 - 2 * green));
    }
    return factors;
}

// The integral of 1 / h^3 over the space that takes points.
double free_size_of(const std::vector<Cell>& cells) {
    double sum = 0;
    for (const Cell& cell : cells) sum += cell.share * cell.volume() / (cell.size * cell.size * cell.size);
    return sum;
}

std::uint64_t automatic_count(double free_size) {
    constexpr double more_than_anyone_wants = 1e15;  // and still a whole number
    return static_cast<std::uint64_t>(std::llround(std::min(free_size / volume_a_point, more_than_anyone_wants)));
}

void measure_space(Report& report, const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
        if (cell.share == 0) continue;
        report.free_volume += cell.share * cell.volume();
        report.size_min = report.size_min == 0 ? cell.size : std::min(report.size_min, cell.size);
        report.size_max = std::max(report.size_max, cell.size);
    }
}

void add_finding(Report& report, std::string code, Severity severity, std::string message) {
    report.findings.push_back({std::move(code), severity, std::move(message), 1, {}});
}

std::uint64_t limited(std::uint64_t count, Report& report) {
    if (count <= max_count) return count;
    add_finding(report, "SAMPLE_COUNT_LIMITED", Severity::warning,
                std::to_string(count) + " points would be needed; " + std::to_string(max_count) +
                    " were asked for. Some edges of the shell are very short: clean them up, or give a count");
    return max_count;
}

std::uint64_t wanted_points(const Count& count, std::uint64_t shell_vertices, Report& report) {
    // A lattice that import put around a shell brings its own points.
    if (count.kind == CountKind::automatic)
        return limited(report.automatic_count - std::min(report.automatic_count, report.given_points), report);
    if (count.kind == CountKind::points) return count.number;
    const std::uint64_t points = points_for_tets(shell_vertices, count.number);
    if (points == 0) {
        add_finding(report, "SAMPLE_FEWER_TETS", Severity::warning,
                    "the shell's own vertices make about " + std::to_string(expected_tets(shell_vertices, 0)) +
                        " tets, more than the " + std::to_string(count.number) + " asked for; give a coarser shell");
    }
    return limited(points, report);
}

void judge_outcome(Report& report, CountKind kind, const Space& space) {
    if (!space.is_watertight()) {
        add_finding(
            report, "SAMPLE_OPEN_SHELL", Severity::info,
            "the shell is open or wound inconsistently, so what counts as inside is a matter of degree near its gaps");
    }
    if (report.points >= report.wanted && report.wanted > 0) return;
    if (report.wanted > 0) {
        const Severity severity = kind == CountKind::automatic ? Severity::info : Severity::warning;
        add_finding(report, "SAMPLE_FEWER_POINTS", severity,
                    std::to_string(report.points) + " of " + std::to_string(report.wanted) +
                        " points found room far enough from the shell; a lower sample.clearance makes more");
    } else if (report.automatic_count == 0) {
        add_finding(
            report, "SAMPLE_NO_INTERIOR", Severity::info,
            "no interior points: the shell is thinner than its triangles are wide, or all of it is rigid, locked or "
            "open. The tets will hang on shell vertices alone");
    }
}

// A larger clearance makes nothing thinner.
void judge_thickness(Report& report, const Shell& shell, double clearance, const Context& context) {
    const ThinParts thin = find_thin_parts(shell, std::min(clearance, Params{}.clearance), context);
    report.thin_triangles = thin.triangles;
    report.thin_share = thin.area_share;
    report.thinnest = thin.least_thickness;
    for (Finding& finding : describe_thin_parts(thin)) report.findings.push_back(std::move(finding));
}

std::uint64_t count_given(const Shell& shell, const Space& space) {
    std::vector<std::uint8_t> is_free(shell.positions.size(), 1);
    for (const Triangle& triangle : shell.triangles) {
        for (const Index v : triangle) is_free[v] = 0;
    }
    std::uint64_t count = 0;
    for (std::size_t v = 0; v < is_free.size(); ++v) count += is_free[v] && space.is_fillable(shell.positions[v]);
    return count;
}

std::vector<double> size_factors(const Shell& shell, bool painted_density, Report& report) {
    if (!painted_density) return {};
    if (shell.color.size() == shell.positions.size()) return painted_size_factors(shell);
    add_finding(report, "SAMPLE_NO_DENSITY", Severity::warning,
                "the density should follow the green channel, but the shell has no colours");
    return {};
}

}

void check_params(const Params& params) { (void)parse_count(params.points); }

Result sample_interior(const Shell& shell, const Params& params, const Context& context) {
    const Count count = parse_count(params.points);
    Result result{{shell.positions, static_cast<Index>(shell.positions.size())}, {}};
    Report& report = result.report;
    report.shell_vertices = shell.positions.size();

    const Space space(shell, size_factors(shell, params.painted_density, report));
    context.tell_progress("sample: find room", 0);
    const std::vector<Cell> cells = find_cells(space, params.clearance, context);
    measure_space(report, cells);
    const double free_size = free_size_of(cells);
    report.automatic_count = automatic_count(free_size);
    report.given_points = count_given(shell, space);
    report.wanted = wanted_points(count, report.shell_vertices, report);

    context.tell_progress("sample: place points", 0.3);
    const Drawing drawing{space, cells, Density::by_size, params.clearance, 0, params.seed};
    const Chosen chosen = method_function(params.method)(drawing, report.wanted, free_size, context);
    result.points.positions.insert(result.points.positions.end(), chosen.points.begin(), chosen.points.end());
    report.points = chosen.points.size();
    report.candidates = chosen.candidates;
    report.tries = chosen.tries;
    report.spacing = chosen.spacing;
    report.expected_tets = expected_tets(report.shell_vertices, report.points);
    judge_outcome(report, count.kind, space);
    judge_thickness(report, shell, params.clearance, context);
    return result;
}

MethodFunction method_function(Method method) {
    switch (method) {
        case Method::poisson:
            return choose_poisson;
        case Method::uniform:
            return choose_uniform;
    }
    throw Error(ErrorKind::internal, "internal: an unknown sampling method");
}

}
