// The fingerprint of a run: a checkpoint of a model that differs is refused and the part is named, by numbers to their
// last digits, and by functions, of which their presence counts. That each field of a script makes another run is in
// tests/script/run/fingerprint_test.lua.
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
    Dynamics start() const { return dynamics(build(), settings); }
};

/// A field, the part that a message names when it differs, and a change of it.
struct Field {
    const char* part;
    const char* name;
    std::function<void(Declared&)> change;
};

/// Numbers of each part, and those that no script has.
std::vector<std::pair<const char*, std::vector<double*>>> numbers_of(Declared& d) {
    contact::ContactSettings& c = d.contact.settings;
    return {{"nodes", {&d.nodes[1].position.x()}},
            {"members", {&d.first.up.y()}},
            {"loads", {&d.load.force.z(), &d.load.moment.x()}},
            {"gravity", {&d.gravity->z()}},
            {"velocities", {&d.velocity.x(), &d.spin.z()}},
            {"materials", {&d.material.E}},
            {"sections", {&d.section.Ix, &d.section.mass_Iy}},
            {"fracture", {&d.fracture.curvature_x, &d.fracture.shear_strain}},
            {"contact", {&c.friction, &c.parting_energy, &c.longest_hold, &c.shortest_gap}},
            {"settings of the run", {&d.settings.beta, &d.settings.solver.tolerance}}};
}

#define CHANGE(part, name, ...)                      \
    Field {                                          \
        part, name, [](Declared& d) { __VA_ARGS__; } \
    }

const std::vector<Field> fields = {
    CHANGE("groups", "of a member", d.second.groups = {0}),
    CHANGE("groups (2 there, 3 here)", "number", d.names.push_back("more")),
    CHANGE(
        "loads", "history", d.load.history = [](double) { return 1.0; }),
    CHANGE(
        "loads", "force by a function", d.load.force_rule = [](double) -> Vec3 { return Vec3::Zero(); }),
    CHANGE(
        "loads", "moment by a function", d.load.moment_rule = [](double) -> Vec3 { return Vec3::Zero(); }),
    CHANGE("gravity (1 there, 0 here)", "none", d.gravity.reset()),
    CHANGE("moving supports", "node", d.moved_node = 0),
    CHANGE(
        "fracture", "a function", d.fracture.hook = [](const SectionView&) { return false; }),
    CHANGE(
        "contact", "a function of pairs",
        d.contact.pairs = [](int, int) { return std::optional<contact::ContactSettings>(); }),
    CHANGE(
        "contact", "on_contact", d.contact.on_contact = [](const contact::ContactEvent&, int, int) {}),
    CHANGE(
        "contact", "on_release", d.contact.on_release = [](const contact::ContactEvent&, int, int) {}),
    CHANGE("options of the model", "formulation", d.options.formulation = Formulation::asi),
    CHANGE("duration", "duration", d.settings.duration = 2e-2),
    CHANGE("dt", "dt", d.settings.dt = 5e-5),
    CHANGE("dt", "automatic", d.settings.automatic = true),
};

}  // namespace

TEST_CASE("fingerprint: each field alone makes a checkpoint one of another run, and its part is named") {
    const Declared whole;
    const Dynamics there = whole.start();
    const std::string bytes = checkpoint_of(there);
    const Checkpoint found = open_checkpoint(bytes, "file");
    CHECK(difference(fingerprint(there), fingerprint(Declared().start())).empty());
    const auto differs = [&](const char* part, const Declared& changed) {
        Dynamics here = changed.start();
        CHECK(difference(fingerprint(there), fingerprint(here)) == part);
        CHECK_THROWS_WITH(resume(here, found, "file"),
                          Catch::Contains("is of another run, which differs in " + std::string(part) + ";"));
    };
    for (const Field& field : fields) {
        INFO(field.part << ": " << field.name);
        Declared changed;
        field.change(changed);
        differs(field.part, changed);
    }
    Declared plain;
    const auto numbers = numbers_of(plain);
    for (std::size_t part = 0; part < numbers.size(); ++part)
        for (std::size_t i = 0; i < numbers[part].second.size(); ++i) {
            INFO(numbers[part].first << ": number " << i);
            Declared changed;
            double& x = *numbers_of(changed)[part].second[i];
            x = std::isfinite(x) && x != 0 ? x * (1 + 1e-15) : 1e-3;  // by its last digits
            differs(numbers[part].first, changed);
        }
}

TEST_CASE("fingerprint: rules, mass and steps make another run; threads do not") {
    const auto between = [](const std::function<void(Declared&)>& there, const std::function<void(Declared&)>& here) {
        Declared one, other;
        there(one);
        here(other);
        return difference(fingerprint(one.start()), fingerprint(other.start()));
    };
    // a rule between two groups against one within them
    const auto groups = [](bool apart) {
        return [apart](Declared& d) { d.contact.groups = {0, 1}, d.contact.between = apart; };
    };
    CHECK(between(groups(false), groups(true)) == "contact");
    // the mass of a cubic shape goes with no fracture rule
    CHECK(between([](Declared&) {}, [](Declared& d) { d.options.mass = MassShape::cubic; }) ==
          "options of the model and fracture (1 there, 0 here)");
    // explicit steps
    CHECK(between([](Declared&) {}, [](Declared& d) { d.settings.beta = 0; }) == "settings of the run");
    // the number of threads changes no bit, and may be another
    CHECK(between([](Declared&) {}, [](Declared& d) { d.settings.threads = 2; }).empty());
}
