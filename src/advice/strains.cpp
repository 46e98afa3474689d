// Strains that no material bears: of elastic members without a yield stress, and of members stretched to more
// than half as long again.
#include <algorithm>
#include <cmath>
#include <limits>

#include "advice/adviser.h"
#include "core/text.h"
#include "model/member_text.h"
#include "state/element_heat.h"

namespace hinge {
namespace {

constexpr long strains_every = 10;  ///< steps of dynamics between looks

/// The elastic strain that no material of this modulus comes to. From 50 GPa: metals, glass; the strongest strand of
/// steel for prestress yields at 0.95 %. From 5 GPa: concrete, timber, composites; aramid breaks at 3 %. From 0.5 GPa:
/// plastics and ropes. Rubber has no limit here.
double most_elastic_strain(double E) {
    return E >= 50e9 ? 0.01 : E >= 5e9 ? 0.03 : E >= 0.5e9 ? 0.3 : std::numeric_limits<double>::infinity();
}

/// Of the length of a member, plastic strain included; of materials from 5 GPa. The toughest steels
/// break at 0.6.
constexpr double most_stretch = 0.6;

/// m, the largest shear stress of a torque over Mz / J: of an H the thickness, of pipes and square boxes half of their
/// width, of a square 0.675 of it; 0 where it is not known.
double torsion_arm(const Section& s) {
    if (s.shape == "h") return std::max(s.web, s.flange);
    if (s.shape == "solid") return 0.675 * std::min(s.width, s.depth);
    const bool round = s.shape == "box" || s.shape == "pipe" || s.shape == "round";
    return round ? 0.5 * std::min(s.width, s.depth) : 0;
}

class UnrealStrains : public Adviser {
public:
    explicit UnrealStrains(const Workspace& w) : w_(w) {
        for (const Element& e : w.structure.elements()) {
            const MemberData& m = w.structure.model().members()[e.member];
            const bool elastic = !std::isfinite(m.material->yield_stress) && (!e.law || m.carries != Carries::both);
            const double most = elastic ? most_elastic_strain(m.material->E) : infinite;
            of_.push_back({1 / (most * e.rigidity.EA), 0.5 * m.section->depth / (most * e.rigidity.EIx),
                           0.5 * m.section->width / (most * e.rigidity.EIy),
                           std::sqrt(3.0) * torsion_arm(*m.section) / (most * m.material->E * m.section->J),
                           w.structure.large() && m.material->E >= 5e9 && m.carries != Carries::compression});
        }
    }

    void after_commit(const Run&, const Step& step) override {
        if (w_.is_due_every(strains_every)) compare(w_.reached(step), elastic_, stretched_);
    }

    void list_findings(const Run&, std::vector<Warning>& list) const override {
        Worst elastic = elastic_, stretched = stretched_;
        compare(w_.kind.dynamic ? w_.state.time : w_.state.factor, elastic, stretched);
        const Model& model = w_.structure.model();
        const auto text = [&](const Worst& w) {
            return member_text(model, w_.structure.elements()[w.element].member) + " comes to ";
        };
        const auto when = [&](const Worst& w) {
            return w_.goes_by_load_factor() ? " at load factor " + number_text(w.at, 3)
                                            : " at t = " + number_text(w.at, 4) + " s";
        };
        if (elastic.element >= 0) {
            const int member = w_.structure.elements()[elastic.element].member;
            const double E = model.members()[member].material->E, strain = elastic.part * most_elastic_strain(E);
            list.push_back({Warning::Kind::strength,
                            text(elastic) + "an elastic stress of " + number_text(1e-9 * E * strain, 2) +
                                " GPa, a strain of " + number_text(100 * strain, 2) + " %," + when(elastic) +
                                ", more than any such material bears, and its material declares no yield stress",
                            "give the material a yield_stress, and model:fracture where members may break",
                            line_of_member(model, member)});
        }
        if (stretched.element >= 0)
            list.push_back({Warning::Kind::strength,
                            text(stretched) + "1 + " + number_text(stretched.part, 2) + " times its length" +
                                when(stretched) + ", and no metal is stretched that far before it breaks",
                            "declare model:fracture with a limit of axial_strain or elongation",
                            line_of_member(model, w_.structure.elements()[stretched.element].member)});
    }

    void save(Writer& to) const override { to(elastic_, stretched_); }
    void restore(Reader& from) override { from(elastic_, stretched_); }
    bool fits(const Run&) const override {
        const int elements = int(w_.structure.elements().size());
        return elastic_.element < elements && stretched_.element < elements;
    }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    /// What N, Mx, My and Mz of an element have of the strain that is too much, per N and per N m. A shear stress
    /// counts as sqrt(3) times one in tension (von Mises).
    struct Limits {
        double N, Mx, My, Mz;
        bool stretches;  ///< its length counts
    };
    struct Worst {
        double part = 0;  ///< of the strain that is too much; of the length
        double at = 0;    ///< s, or load factor
        int element = -1;
        template <class Self, class A>
        static void fields(Self& s, A& a) {
            a(s.part, s.at, s.element);
        }
    };

    void compare(double at, Worst& elastic, Worst& stretched) const {
        compare_forces(at, elastic);
        compare_lengths(at, stretched);
    }

    void compare_forces(double at, Worst& elastic) const {
        const State& s = w_.state;
        for (std::size_t i = 0; i < of_.size(); ++i) {
            const Limits& of = of_[i];
            if (s.broken[i] || !(of.N > 0)) continue;
            const Vec6& p = s.force[i];
            const double part = of.N * std::abs(p[4]) + of.Mx * std::max(std::abs(p[0]), std::abs(p[1])) +
                                of.My * std::max(std::abs(p[2]), std::abs(p[3])) + of.Mz * std::abs(p[5]);
            if (part > 1 && part > elastic.part) elastic = {part / heat_of(s.heat, int(i)).stiffness, at, int(i)};
        }
    }

    /// Of whole members: in which of its elements one without hardening flows is chance.
    void compare_lengths(double at, Worst& stretched) const {
        const State& s = w_.state;
        const auto& elements = w_.structure.elements();
        for (std::size_t i = 0; i < of_.size();) {
            const std::size_t first = i;
            double before = 0, now = 0;
            bool whole = of_[i].stretches;
            for (; i < of_.size() && elements[i].member == elements[first].member; ++i) {
                const Element& e = elements[i];
                whole = whole && !s.broken[i];
                if (!whole) continue;
                before += e.length;
                now += (e.chord + s.displacement[e.node[1]] - s.displacement[e.node[0]]).norm();
            }
            if (whole && now > (1 + most_stretch) * before && now / before - 1 > stretched.part)
                stretched = {now / before - 1, at, int(first)};
        }
    }

    const Workspace& w_;
    std::vector<Limits> of_;
    Worst elastic_, stretched_;
};

}  // namespace

std::unique_ptr<Adviser> advise_of_strains(const Run& run, WarningLog&) {
    return std::make_unique<UnrealStrains>(run.workspace());
}

}  // namespace hinge
