#include "run/fingerprint.h"

#include <zlib.h>

#include <algorithm>

#include "section/material_law.h"
#include "section/section_outline.h"
#include "core/archive.h"

namespace hinge {
namespace {

/// Sums up what is written.
class Sum {
public:
    static constexpr bool reading = false;
    template <class... T>
    void operator()(const T&... values) {
        (archive::value(*this, values), ...);
    }
    void bytes(const void* from, std::size_t n) {
        if (n == 0) return;  // an empty list has no address, for which crc32_z would begin anew
        sum_ = std::uint32_t(crc32_z(sum_, static_cast<const Bytef*>(from), n));
    }
    std::uint32_t value() const { return sum_; }

private:
    std::uint32_t sum_ = 0;
};

void add_outline(Sum& a, const beam::Outline& outline) {
    for (const beam::Outline::Polygon& p : outline.polygons) a(p.corners, p.hole);
    for (const beam::Outline::Circle& c : outline.circles) a(c.centre, c.radius, c.hole);
}

/// A part: `add` puts each of `list` into the sum.
template <class List, class Add>
FingerprintPart part(const char* name, const List& list, Add add) {
    Sum sum;
    for (const auto& each : list) add(sum, each);
    return {name, list.size(), sum.value()};
}

void add_section(Sum& a, const Section& section) {
    a(section.area, section.Ix, section.Iy, section.J, section.shear_area_x, section.shear_area_y, section.mass_Ix,
      section.mass_Iy, section.plastic_area, section.Zx, section.Zy, section.Zz, section.given.N0, section.given.Mx0,
      section.given.My0, section.given.Mz0, section.width, section.depth, section.interaction, section.shape);
    for (const auto& walls : section.walls)
        for (const Section::Wall& w : walls) a(w.x0, w.x1, w.y0, w.y1);
    if (section.outline) add_outline(a, section.outline->outline());
    if (!section.outline || !section.outline->concrete()) return;
    a(section.outline->concrete()->concrete);
    if (const auto& strains = section.outline->concrete()->strains)
        a(strains->peak, strains->ultimate, strains->exponent, strains->block, strains->bars);
    for (const auto& bar : section.outline->concrete()->bars)
        a(bar.centre.x(), bar.centre.y(), bar.area, bar.tension, bar.compression);
}

}  // namespace

std::vector<FingerprintPart> fingerprint(const Dynamics& run) {
    const Model& model = run.structure().model();
    const DynamicSettings& s = run.settings();
    std::vector<FingerprintPart> parts;
    parts.push_back(part("nodes", model.nodes(), [](Sum& a, const NodeData& n) { a(n.position, n.fixed); }));
    parts.push_back(part("members", model.members(), [](Sum& a, const MemberData& m) {
        a(m.node, m.up, m.elements, m.carries);
        if (!m.is_straight()) a(m.bow, m.inner);
        if (m.line_mass > 0) a(m.line_mass);
    }));
    parts.push_back(part("materials", model.members(), [](Sum& a, const MemberData& m) {
        a(m.material->E, m.material->G, m.material->density, m.material->yield_stress);
        const auto add = [&](const beam::MaterialLaw& law) {
            std::string bytes;
            Writer write(bytes);
            law.save(write);
            a(std::string(law.name()), bytes);
        };
        for (const auto& law : m.material->laws) add(*law);
        if (m.backbone) add(*m.backbone);
        if (m.law) add(*m.law);
    }));
    parts.push_back(part("sections", model.members(), [](Sum& a, const MemberData& m) { add_section(a, *m.section); }));
    parts.push_back(part("groups", model.members(), [](Sum& a, const MemberData& m) { a(m.groups); }));
    parts.back().count = model.groups().size();
    parts.push_back(part("velocities", model.velocities(), [](Sum& a, const Vec6& v) { a(v); }));
    parts.push_back(part("options of the model", std::vector{model.options()}, [](Sum& a, const ModelOptions& o) {
        a(o.formulation, o.displacement, o.shift, o.mass, o.p_delta, o.weight, o.plasticity, o.interaction,
          o.elements_per_member);
    }));
    parts.push_back(part("duration", std::vector{s.duration}, [](Sum& a, double duration) { a(duration); }));
    parts.push_back(part("dt", std::vector{run.shortest()}, [&](Sum& a, double dt) { a(dt, s.automatic); }));
    parts.push_back(part("settings of the run", std::vector{s}, [](Sum& a, const DynamicSettings& settings) {
        a(settings.beta, settings.iterations, settings.predictor, settings.tolerance, settings.geometric,
          settings.rebuild_angle, settings.single_precision, settings.energy_tolerance, settings.step_control,
          settings.controlled_by_default, settings.rho_infinity, settings.conserving, settings.rest,
          settings.solver.direct, settings.solver.tolerance, settings.solver.max_iterations);
    }));
    for (const auto& [effect, what] : model.declarations()) {
        if (what->count() == 0) continue;  // all are removed, or none acts in this run
        std::string bytes;
        Writer write(bytes);
        what->save(write);
        parts.push_back(part(effect.c_str(), std::vector{bytes}, [](Sum& a, const std::string& b) { a(b); }));
        parts.back().count = what->count();
    }
    return parts;
}

std::string difference(const std::vector<FingerprintPart>& there, const std::vector<FingerprintPart>& here) {
    const auto find = [](const std::vector<FingerprintPart>& parts, const std::string& name) {
        const auto at = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
        return at == parts.end() ? FingerprintPart{name, 0, 0} : *at;
    };
    std::vector<std::string> names;
    const auto compare = [&](const FingerprintPart& a, const FingerprintPart& b) {
        if (a.count == b.count && a.sum == b.sum) return;
        names.push_back(a.name);
        if (a.count != b.count)
            names.back() += " (" + std::to_string(a.count) + " there, " + std::to_string(b.count) + " here)";
    };
    for (const FingerprintPart& part : here) compare(find(there, part.name), part);
    for (const FingerprintPart& part : there)
        if (std::none_of(here.begin(), here.end(), [&](const auto& p) { return p.name == part.name; }))
            compare(part, find(here, part.name));
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

}  // namespace hinge
