// The fingerprint of a run, field by field: a checkpoint of a model that differs in one of them is refused, and the
// part is named.
#include <functional>

#include "core/errors.h"
#include "helpers.h"
#include "run/checkpoint.h"

using namespace hinge;
using namespace hinge::test;

namespace {

/// All that a fingerprint reads, to be changed in one place before it is declared.
struct Declared {
    ModelOptions options;
    std::vector<NodeData> nodes{{{0, 0, 0}, 63}, {{1, 0, 0.5}, 0}, {{2, 0, 0}, 63}};
    Section section = *square(0.05);
    Material material = *steel(250e6);
    std::vector<std::string> names{"beams", "columns"};
    MemberData first{{0, 1}, nullptr, nullptr, {0, 0, 1}, 2, {0}}, second{{1, 2}, nullptr, nullptr, {0, 0, 1}, 2, {1}};
    NodalLoad load;
    std::optional<Vec3> gravity = Vec3(0, 0, -9.8);
    Vec3 velocity{1, 0, 0}, spin{0, 0, 1};
    int moved_node = 2, moved_component = 0;
    FractureRule fracture;
    ContactRule contact;
    DynamicSettings settings;

    Declared() {
        load.node = 1;
        load.force = {0, 0, -10};
        fracture.curvature_x = fracture.curvature_y = fracture.axial_strain = 10;
        contact.settings.rule = contact::ContactRuleKind::surface;
        settings.dt = 1e-4;
        settings.duration = 1e-2;
        settings.iterations = 1;
    }
    std::shared_ptr<const Structure> build() const {
        auto model = std::make_shared<Model>(options);
        for (const NodeData& n : nodes) {
            model->add_node(n.position);
            model->fix(int(model->nodes().size()) - 1, n.fixed);
        }
        for (const std::string& name : names) model->group(name);
        for (MemberData m : {first, second}) {
            m.section = std::make_shared<Section>(section);
            m.material = std::make_shared<Material>(material);
            model->add_member(m);
        }
        add_load(*model, load);
        if (gravity) set_gravity(*model, *gravity);
        model->set_velocity(1, velocity, spin);
        add_motion(*model, {moved_node, moved_component, [](double) { return 0.0; }});
        if (options.mass == MassShape::linear) add_fracture(*model, fracture);
        add_contact(*model, contact);
        return std::make_shared<const Structure>(model, settings.beta == 0 ? MassKind::lumped : MassKind::consistent);
    }
    Dynamics start() const {
        const auto structure = build();
        return Dynamics(structure, initial_state(*structure), settings);
    }
};

/// A field, the part that a message names when it differs, and a change of it.
struct Field {
    const char* part;
    const char* name;
    std::function<void(Declared&)> change;
};

/// A change of one number by its last digits: what is not summed up to the last bit is not summed up.
template <class Number>
void nudge(Number& x) {
    x = std::isfinite(x) && x != 0 ? x * (1 + 1e-15) + 0 : 1e-3;
}

#define NUMBER(part, name)                              \
    Field {                                             \
        part, #name, [](Declared& d) { nudge(d.name); } \
    }
#define CHANGE(part, name, ...)                      \
    Field {                                          \
        part, name, [](Declared& d) { __VA_ARGS__; } \
    }

const std::vector<Field> fields = {
    CHANGE("nodes", "position x", nudge(d.nodes[1].position.x())),
    CHANGE("nodes", "position y", nudge(d.nodes[1].position.y())),
    CHANGE("nodes", "position z", nudge(d.nodes[1].position.z())),
    CHANGE("nodes", "fixed", d.nodes[0].fixed = 31),
    CHANGE("members", "first node", d.second.node[0] = 0),
    CHANGE("members", "second node", d.first.node[1] = 2),
    CHANGE("members", "up", nudge(d.first.up.y())),
    CHANGE("members", "elements", d.first.elements = 4),
    NUMBER("materials", material.E),
    NUMBER("materials", material.G),
    NUMBER("materials", material.density),
    NUMBER("materials", material.yield_stress),
    NUMBER("sections", section.area),
    NUMBER("sections", section.Ix),
    NUMBER("sections", section.Iy),
    NUMBER("sections", section.J),
    NUMBER("sections", section.shear_area_x),
    NUMBER("sections", section.shear_area_y),
    NUMBER("sections", section.mass_Ix),
    NUMBER("sections", section.mass_Iy),
    NUMBER("sections", section.plastic_area),
    NUMBER("sections", section.Zx),
    NUMBER("sections", section.Zy),
    NUMBER("sections", section.Zz),
    CHANGE("sections", "N0", d.section.given.N0 = 1e5),
    CHANGE("sections", "Mx0", d.section.given.Mx0 = 1e5),
    CHANGE("sections", "My0", d.section.given.My0 = 1e5),
    CHANGE("sections", "Mz0", d.section.given.Mz0 = 1e5),
    NUMBER("sections", section.width),
    NUMBER("sections", section.depth),
    CHANGE("groups", "of a member", d.second.groups = {0}),
    CHANGE("groups (2 there, 3 here)", "number", d.names.push_back("more")),
    CHANGE("loads", "node", d.load.node = 0),
    CHANGE("loads", "force", nudge(d.load.force.z())),
    CHANGE("loads", "moment", nudge(d.load.moment.x())),
    CHANGE(
        "loads", "history", d.load.history = [](double) { return 1.0; }),
    CHANGE(
        "loads", "force by a function", d.load.force_rule = [](double) -> Vec3 { return Vec3::Zero(); }),
    CHANGE(
        "loads", "moment by a function", d.load.moment_rule = [](double) -> Vec3 { return Vec3::Zero(); }),
    CHANGE("gravity (1 there, 0 here)", "none", d.gravity.reset()),
    CHANGE("gravity", "its size", nudge(d.gravity->z())),
    CHANGE("velocities", "velocity", nudge(d.velocity.x())),
    CHANGE("velocities", "angular velocity", nudge(d.spin.z())),
    CHANGE("moving supports", "node", d.moved_node = 0),
    CHANGE("moving supports", "component", d.moved_component = 1),
    NUMBER("fracture", fracture.curvature_x),
    NUMBER("fracture", fracture.curvature_y),
    NUMBER("fracture", fracture.axial_strain),
    NUMBER("fracture", fracture.shear_strain),
    CHANGE("fracture", "hinge_rotation_x", d.fracture.hinge_rotation_x = 0.1),
    CHANGE("fracture", "hinge_rotation_y", d.fracture.hinge_rotation_y = 0.1),
    CHANGE("fracture", "elongation", d.fracture.elongation = 0.1),
    CHANGE("fracture", "tension_only", d.fracture.tension_only = true),
    CHANGE("fracture", "reading", d.fracture.strain_measure = FractureRule::StrainMeasure::section),
    CHANGE("fracture", "plastic_only", d.fracture.plastic_only = true),
    CHANGE(
        "fracture", "a function", d.fracture.hook = [](const SectionView&) { return false; }),
    CHANGE("fracture", "where", d.fracture.where = FractureRule::Where::all),
    CHANGE("fracture", "keep", d.fracture.keep = {"damage"}),
    CHANGE("fracture", "group", d.fracture.group = 0),
    CHANGE("contact", "rule", d.contact.settings.rule = contact::ContactRuleKind::gap),
    CHANGE("contact", "sleep", d.contact.settings.sleep = false),
    NUMBER("contact", contact.settings.stiffness),
    NUMBER("contact", contact.settings.friction),
    NUMBER("contact", contact.settings.contact_length),
    NUMBER("contact", contact.settings.coplanarity_tolerance),
    NUMBER("contact", contact.settings.binding_time),
    CHANGE("contact", "as printed", d.contact.settings.as_printed = true),
    CHANGE("contact", "signed f", d.contact.settings.signed_f = true),
    CHANGE("contact", "hold_until_parting", d.contact.settings.hold_until_parting = false),
    NUMBER("contact", contact.settings.parting_energy),
    NUMBER("contact", contact.settings.longest_hold),
    NUMBER("contact", contact.settings.shortest_gap),
    CHANGE("contact", "groups", d.contact.groups = {0, 1}),
    CHANGE(
        "contact", "a function of pairs",
        d.contact.pairs = [](int, int) { return std::optional<contact::ContactSettings>(); }),
    CHANGE(
        "contact", "on_contact", d.contact.on_contact = [](const contact::ContactEvent&, int, int) {}),
    CHANGE(
        "contact", "on_release", d.contact.on_release = [](const contact::ContactEvent&, int, int) {}),
    CHANGE("options of the model", "formulation", d.options.formulation = Formulation::asi),
    CHANGE("options of the model", "displacement", d.options.displacement = Displacement::small),
    CHANGE("options of the model", "shift", d.options.shift = Shift::elastic_and_plastic),
    CHANGE("options of the model", "plasticity", d.options.plasticity = false),
    CHANGE("options of the model", "elements_per_member", d.options.elements_per_member = 4),
    CHANGE("options of the model", "weight", d.options.weight = Weight::nodes),
    CHANGE("duration", "duration", d.settings.duration = 2e-2),
    CHANGE("dt", "dt", d.settings.dt = 5e-5),
    CHANGE("dt", "automatic", d.settings.automatic = true),
    NUMBER("settings of the run", settings.beta),
    NUMBER("settings of the run", settings.tolerance),
    NUMBER("settings of the run", settings.rebuild_angle),
    NUMBER("settings of the run", settings.solver.tolerance),
    CHANGE("settings of the run", "iterations", d.settings.iterations = 7),
    CHANGE("settings of the run", "predictor", d.settings.predictor = Predictor::displacement),
    CHANGE("settings of the run", "geometric", d.settings.geometric = false),
    CHANGE("settings of the run", "narrow", d.settings.single_precision = false),
    CHANGE("settings of the run", "energy_tolerance", d.settings.energy_tolerance = 0.2),
    CHANGE("settings of the run", "step_control", d.settings.step_control = 0.01),
    CHANGE("settings of the run", "rho_infinity", d.settings.rho_infinity = 0.9),
    CHANGE("settings of the run", "rest", d.settings.rest = false),
    CHANGE("settings of the run", "direct", d.settings.solver.direct = true),
    CHANGE("settings of the run", "max_iterations", d.settings.solver.max_iterations = 77),
};

}  // namespace

TEST_CASE("fingerprint: each field alone makes a checkpoint one of another run, and its part is named",
          "[fingerprint]") {
    const Declared whole;
    const Dynamics there = whole.start();
    const std::string bytes = checkpoint_of(there);
    const Checkpoint found = open_checkpoint(bytes, "file");
    CHECK(difference(fingerprint(there), fingerprint(Declared().start())).empty());
    for (const Field& field : fields) {
        INFO(field.part << ": " << field.name);
        Declared changed;
        field.change(changed);
        Dynamics here = changed.start();
        CHECK(difference(fingerprint(there), fingerprint(here)) == field.part);
        CHECK_THROWS_WITH(resume(here, found, "file"),
                          Catch::Contains("is of another run, which differs in " + std::string(field.part) + ";"));
    }
}

TEST_CASE("fingerprint: rules, mass and steps make another run; threads do not", "[fingerprint]") {
    const auto between = [](const std::function<void(Declared&)>& there, const std::function<void(Declared&)>& here) {
        Declared one, other;
        there(one);
        here(other);
        return difference(fingerprint(one.start()), fingerprint(other.start()));
    };
    // a rule between two groups against one within them
    CHECK(between(
              [](Declared& d) {
                  d.contact.groups = {0, 1};
              },
              [](Declared& d) {
                  d.contact.groups = {0, 1}, d.contact.between = true;
              }) == "contact");
    // the mass of a cubic shape goes with no fracture rule
    CHECK(between([](Declared&) {}, [](Declared& d) { d.options.mass = MassShape::cubic; }) ==
          "options of the model and fracture (1 there, 0 here)");
    // explicit steps
    CHECK(between([](Declared&) {}, [](Declared& d) { d.settings.beta = 0; }) == "settings of the run");
    // the number of threads changes no bit, and may be another
    CHECK(between([](Declared&) {}, [](Declared& d) { d.settings.threads = 2; }).empty());
}
