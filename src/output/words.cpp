// Labels at points of a scene: numbers of nodes and members, values of diagrams and loads.
#include "output/words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hinge::output {
namespace {

struct Place {
    double left, low, right, top;
    bool overlaps(const Place& o) const { return left < o.right && o.left < right && low < o.top && o.low < top; }
};

}  // namespace

int draw_words(Pen& pen, const std::vector<Word>& words, const Camera& camera, double low, double em) {
    std::vector<const Word*> order;
    for (const Word& w : words) order.push_back(&w);
    std::stable_sort(order.begin(), order.end(), [](const Word* a, const Word* b) {
        return a->rank != b->rank ? a->rank > b->rank : a->weight > b->weight;
    });
    std::vector<Place> occupied;
    int left_out = 0;
    for (const Word* w : order) {
        const Vec p = camera.project(w->at);
        if (!(p[2] > 0) || p[0] < 0 || p[1] < 0 || p[0] > camera.width || p[1] > camera.height) continue;
        const TextStyle style{.size = w->size * em, .colour = w->colour, .bold = w->bold};
        const auto size_of_text = pen.size_of(w->text, style);
        const double wide = size_of_text[0], high = size_of_text[1];
        double dx = dot(w->away, camera.right), dy = dot(w->away, camera.up);
        if (const double size = std::hypot(dx, dy); size > 0) dx /= size, dy /= size;
        const double gap = 0.35 * em;
        const double pad = 0.12 * em, edge = wide / 2 + 2 * pad;
        double x = 0, y = 0;
        Place place{};
        const auto free_at = [&](double to_x, double to_y) {
            x = std::clamp(p[0] + to_x * (wide / 2 + gap), edge, std::max(edge, camera.width - edge));
            y = low + p[1] + to_y * (high / 2 + gap);
            place = {x - wide / 2 - pad, y - high / 2 - pad, x + wide / 2 + pad, y + high / 2 + pad};
            return std::none_of(occupied.begin(), occupied.end(), [&](const Place& o) { return place.overlaps(o); });
        };
        // Where it should stand, else beside that, else opposite.
        const bool on_it = dx == 0 && dy == 0;
        if (!free_at(dx, dy) && !free_at(on_it ? 0 : -dy, on_it ? 1 : dx) &&
            !free_at(on_it ? 0 : dy, on_it ? -1 : -dx) && !free_at(on_it ? 1 : -dx, on_it ? 0 : -dy)) {
            ++left_out;
            continue;
        }
        occupied.push_back(place);
        pen.box(place.left, place.low, place.right - place.left, place.top - place.low, white, 0.72);
        TextStyle middle = style;
        middle.across = 0.5;
        pen.text(x, y, w->text, middle);
    }
    return left_out;
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

Unit unit_for(double largest, const std::string& unit) {
    if (largest >= 1e6) return {1e6, "M" + unit};
    if (largest >= 1e3) return {1e3, "k" + unit};
    return {1, unit};
}

}  // namespace hinge::output
