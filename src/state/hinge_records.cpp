#include "state/hinge_records.h"

#include <cmath>

#include "section/fracture_limits.h"

namespace hinge {
namespace {

/// True if the element before it is one of the same member: then end 1 is the section at end 2 of that one.
bool follows(const Structure& structure, int element) {
    const auto& elements = structure.elements();
    return element > 0 && elements[std::size_t(element) - 1].member == elements[std::size_t(element)].member;
}

}  // namespace

HingePart part_of(const Structure& structure, const PlasticIncrement& y, int end) {
    const bool inside = end == 1 && follows(structure, y.element);
    HingePart part{inside ? y.element - 1 : y.element, inside ? 2 : end, inside, {}, 1, 0};
    for (int plane : {0, 1})  // a conventional element bends plastically over its whole length
        part.rotation[plane] =
            end > 0 ? beam::hinge_rotation(y.flow.plastic, end, plane)
                    : beam::hinge_rotation(y.flow.plastic, 1, plane) + beam::hinge_rotation(y.flow.plastic, 2, plane);
    // of a surface of eq 14's kind the work is 2 lambda at each section
    if (end > 0) part.share = y.flow.lambda[end - 1] / (y.flow.lambda[0] + y.flow.lambda[1]);
    part.elongation = part.share * (y.flow.plastic[4] - y.flow.slack);
    return part;
}

HingeMotion motion_of(const Structure& structure, const HingeRecords* records, int element, int end) {
    HingeMotion out;
    if (!records) return out;
    const bool inside = !structure.conventional() && end == 1 && follows(structure, element);
    const long place = structure.conventional() ? 3L * element : inside ? 3L * element - 1 : 3L * element + end;
    const auto at = std::lower_bound(records->list.begin(), records->list.end(), place,
                                     [](const HingeRecord& h, long p) { return h.place() < p; });
    if (at == records->list.end() || at->place() != place) return out;
    for (int plane : {0, 1})
        out.rotation[plane] = inside ? at->of_next[plane] : at->rotation[plane] - at->of_next[plane];
    out.elongation = inside ? at->of_next[2] : at->elongation - at->of_next[2];
    return out;
}

void record_flow(const Structure& structure, const std::vector<PlasticIncrement>& yielding, double at, bool statics,
                 HingeRecords& records) {
    std::vector<HingeRecord>& list = records.list;
    std::size_t now = 0;  // of the section that is being rotated: places rise as the elements do
    const auto done = [&] {
        if (now < list.size())
            list[now].largest = std::max(list[now].largest, std::hypot(list[now].rotation[0], list[now].rotation[1]));
    };
    const auto add = [&](const HingePart& part, const beam::ReturnMapResult& flow) {
        HingeRecord fresh;
        fresh.element = part.element, fresh.end = part.end;
        fresh.statics = statics, fresh.first = at;
        auto found = std::lower_bound(list.begin() + long(now), list.end(), fresh.place(),
                                      [](const HingeRecord& h, long place) { return h.place() < place; });
        if (found != list.begin() + long(now)) done();  // two elements may rotate one section, one after the other
        if (found == list.end() || found->place() != fresh.place()) found = list.insert(found, fresh);
        now = std::size_t(found - list.begin());
        for (int plane : {0, 1}) found->rotation[plane] += part.rotation[plane];
        found->elongation += part.elongation;
        found->work += part.share * flow.dissipation;
        if (!part.of_next) return;
        for (int plane : {0, 1}) found->of_next[plane] += part.rotation[plane];
        found->of_next[2] += part.elongation;
    };
    for (const PlasticIncrement& y : yielding) {
        if (!y.flow.yields()) continue;
        if (structure.conventional()) add(part_of(structure, y, 0), y.flow);
        for (int end : {1, 2})
            if (!structure.conventional() && y.flow.lambda[end - 1] > 0) add(part_of(structure, y, end), y.flow);
    }
    if (!yielding.empty()) done();
}

}  // namespace hinge
