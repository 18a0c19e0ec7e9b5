// SPDX-License-Identifier: MIT
#include "samples/loft.h"

#include <algorithm>

namespace crumple::samples {

Ring add_ring(Part& part, std::span<const Vec3> outline, int count, double offset, Color color) {
    std::vector<double> along{0};  // length up to each point, and the whole length
    for (std::size_t i = 0; i < outline.size(); ++i) {
        along.push_back(along.back() + length(outline[(i + 1) % outline.size()] - outline[i]));
    }
    Ring ring;
    for (int k = 0; k < count; ++k) {
        const double place = (k + offset) / count;
        const double wanted = place * along.back();
        const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, wanted);
        const auto i = static_cast<std::size_t>(after - along.begin()) - 1;
        const double t = (wanted - along[i]) / (along[i + 1] - along[i]);
        ring.vertices.push_back(add_vertex(part, outline[i] * (1 - t) + outline[(i + 1) % outline.size()] * t, color));
        ring.places.push_back(place);
    }
    return ring;
}

void stitch(Part& part, const Ring& from, const Ring& to) {
    const auto place = [](const Ring& ring, std::size_t k) {
        const auto n = ring.places.size();
        return ring.places[k % n] + static_cast<double>(k / n);
    };
    const auto vertex = [](const Ring& ring, std::size_t k) { return ring.vertices[k % ring.vertices.size()]; };
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < from.vertices.size() || b < to.vertices.size()) {
        const bool step_a =
            b == to.vertices.size() || (a < from.vertices.size() && place(from, a + 1) <= place(to, b + 1));
        if (step_a) {
            part.triangles.push_back({vertex(from, a), vertex(from, a + 1), vertex(to, b)});
            ++a;
        } else {
            part.triangles.push_back({vertex(from, a), vertex(to, b + 1), vertex(to, b)});
            ++b;
        }
    }
}

void close_with_point(Part& part, const Ring& ring, Vec3 point, Color color) {
    const Index tip = add_vertex(part, point, color);
    const auto n = ring.vertices.size();
    for (std::size_t k = 0; k < n; ++k) part.triangles.push_back({ring.vertices[k], ring.vertices[(k + 1) % n], tip});
}

void close_by_zipping(Part& part, const Ring& ring) {
    // The ends of the long axis lie at the places 1/4 and 3/4: walk from one to the other along both halves at once.
    const auto n = ring.vertices.size();
    const auto end_at = [&](double place) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < n; ++k) {
            if (std::abs(ring.places[k] - place) < std::abs(ring.places[best] - place)) best = k;
        }
        return best;
    };
    const std::size_t start = end_at(0.25);
    const std::size_t forward_count = (end_at(0.75) + n - start) % n;
    std::size_t forward = 1;  // the first triangle stands on the edge at the start
    std::size_t backward = 0;
    const auto vertex = [&](std::size_t k) { return ring.vertices[(start + k) % n]; };
    while (forward + backward + 1 < n) {
        const bool step_forward = backward >= n - forward_count || (forward < forward_count && forward <= backward);
        const Index a = vertex(forward);
        const Index b = vertex(n - backward);
        if (step_forward) {
            part.triangles.push_back({a, vertex(forward + 1), b});
            ++forward;
        } else {
            part.triangles.push_back({a, vertex(n - backward - 1), b});
            ++backward;
        }
    }
}

Ring reversed(const Ring& ring) {
    Ring result = ring;
    std::reverse(result.vertices.begin(), result.vertices.end());
    std::reverse(result.places.begin(), result.places.end());
    for (auto& place : result.places) place = 1 - place;
    if (!result.places.empty() && result.places.back() == 1) {  // place 0 stays first
        std::rotate(result.places.begin(), result.places.end() - 1, result.places.end());
        std::rotate(result.vertices.begin(), result.vertices.end() - 1, result.vertices.end());
        result.places.front() = 0;
    }
    return result;
}

}
