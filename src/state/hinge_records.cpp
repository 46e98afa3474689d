#include "state/hinge_records.h"

#include <cmath>

#include "beam/fracture_limits.h"

namespace hinge {
namespace {

/// A section's part in the flow of one element.
struct HingePart {
    int element, end;  ///< as in HingeRecord
    double rotation[2], share;
};

/// The section at an end of the element, 1 or 2.
HingePart part_of(const Structure& structure, const PlasticIncrement& y, int end) {
    const int e = y.element, member = structure.elements()[std::size_t(e)].member;
    const bool inside = end == 1 && e > 0 && structure.elements()[std::size_t(e) - 1].member == member;
    HingePart part{inside ? e - 1 : e, inside ? 2 : end, {}, 0};
    for (int plane : {0, 1}) part.rotation[plane] = beam::hinge_rotation(y.flow.plastic, end, plane);
    // of a surface of eq 14's kind the work is 2 lambda at each section
    part.share = y.flow.lambda[end - 1] / (y.flow.lambda[0] + y.flow.lambda[1]);
    return part;
}

/// The middle of a conventional element, which bends plastically over its whole length.
HingePart middle_of(const PlasticIncrement& y) {
    HingePart part{y.element, 0, {}, 1};
    for (int plane : {0, 1})
        part.rotation[plane] =
            beam::hinge_rotation(y.flow.plastic, 1, plane) + beam::hinge_rotation(y.flow.plastic, 2, plane);
    return part;
}

}  // namespace

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
        found->elongation += part.share * (flow.plastic[4] - flow.slack);
        found->work += part.share * flow.dissipation;
    };
    for (const PlasticIncrement& y : yielding) {
        if (!y.flow.yields()) continue;
        if (structure.conventional()) add(middle_of(y), y.flow);
        for (int end : {1, 2})
            if (!structure.conventional() && y.flow.lambda[end - 1] > 0) add(part_of(structure, y, end), y.flow);
    }
    if (!yielding.empty()) done();
}

}  // namespace hinge
