// Moments in the span of compressed members: the axial force acts on the bow of the beam between its ends, and adds a
// moment in the middle of each pair of elements that the balance on the chords does not have (beam/pair_bow.h).
//
// The forces on the nodes do not change. Yield, fracture and all that reads section forces take the moment. The part of
// loads between the ends is in the effects of those loads (PressedPair, clamped_member.h). A hinge between the ends is
// in the middle, and forms when the largest moment of the span reaches the plastic one.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam/pair_bow.h"
#include "core/lanes.h"
#include "effects/clamped_member.h"
#include "effects/kinds.h"
#include "state/hinges.h"

namespace hinge {
namespace {

/// Moments of the middle sections of the pairs in the last accepted step, about x and y, N m. A step from there that
/// begins anew begins with the same forces.
struct BowMoments {
    static constexpr bool in_state_hash = false;
    std::vector<double> list;
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.list);
    }
};

class Bow : public Effect, public SectionForceSource {
public:
    Bow(Workspace& w, Host& host) : Effect("bow", w, host, {.mean_forces = true}) {
        const auto& elements = w.structure.elements();
        blocks_.resize((elements.size() + lane_count - 1) / lane_count);
        added_.assign(blocks_.size() * lane_count / 2, Eigen::Vector2d::Zero());
        if (const auto* before = w.state.data.find<BowMoments>("bow");
            !before || before->list.size() != 2 * added_.size())
            w.state.data.set("bow", BowMoments{std::vector<double>(2 * added_.size(), 0.0)});
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const Element& e = elements[i];
            Block& b = blocks_[i / lane_count];
            const beam::PairKind<double> pair = pair_kind_of(e);
            for (int plane : {0, 1}) {
                b.flexible[plane][i % lane_count] = pair.c[plane];
                beam::put(b.shear[plane], i % lane_count, pair.shear[plane]);
            }
            const double k = std::numbers::pi / (2 * e.length), EI[2] = {e.rigidity.EIx, e.rigidity.EIy};
            for (int plane : {0, 1}) {
                b.omega[plane][i % lane_count] =
                    e.rigidity.rhoA > 0 ? k * k * std::sqrt(EI[plane] / e.rigidity.rhoA) : at_once;
                b.nothing[plane][i % lane_count] = 1e-9 * EI[plane] / e.length;
            }
            b.point[i % lane_count] = -e.s;
            if (!e.law) continue;
            const beam::YieldSurface& y = e.law->screen();
            const double weights[4] = {y.x, y.y, y.n, y.z};
            for (int j = 0; j < 4; ++j) b.yield[j][i % lane_count] = weights[j];
        }
    }

    bool has_fixed_ends() const override {
        any_added_ = false;
        if (w_.at_state) {
            const std::vector<double>& list = kept().list;
            return std::any_of(list.begin(), list.end(), [](double m) { return m != 0; });
        }
        for (std::size_t block = 0; block < blocks_.size() && !any_added_; ++block)
            any_added_ = !rests(int(block)) && (has_kept(int(block)) || counts(int(block), w_.force_of_fixed_ends()));
        return any_added_;
    }
    void add_fixed_ends(const Pose& at, double factor, std::vector<beam::FixedEnd>& all) const override {
        if (w_.at_state) {  // what broke as the last step was kept has none any more
            const std::vector<double>& list = kept().list;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (whole(first_of(int(i)))) add_to(int(i), {list[i / 2 * 2], list[i / 2 * 2 + 1]}, all[i]);
            return;
        }
        const std::vector<Vec6>& force = w_.force_of_fixed_ends();
        w_.pool.share(int(blocks_.size()), 64, [&](int first, int end, int) {
            for (int block = first; block < end; ++block) {
                if (rests(block)) continue;
                for (int i = 0; i < lane_count / 2; ++i) added_[std::size_t(block * lane_count / 2 + i)].setZero();
                if (has_kept(block) || counts(block, force))
                    add_to_block(block, Forces(*this, block, force, all), force, at, factor, all);
            }
        });
    }

    /// The forces of the elements do less work on the flow than the section's: the rest is that of the axial force on
    /// the bow.
    void accumulate_energy(const Step&, Accounts& sums) const override {
        for (const PlasticIncrement& y : w_.yielding) {
            const auto& more = added_[std::size_t(y.element / 2)];
            if (!any_added_ || w_.assembly.fixed_ends().empty() || more.isZero(0)) continue;
            beam::FixedEnd part;
            add_to(y.element, more, part);
            sums["work"] += work_on_flow(y, part);
        }
    }

    void after_commit(const Step&) override {
        std::vector<double>& list = w_.state.data.find<BowMoments>("bow")->list;
        for (std::size_t i = 0; i < added_.size(); ++i)
            for (int plane : {0, 1}) list[2 * i + plane] = any_added_ ? added_[i][plane] : 0;
    }
    bool restored(std::span<const State* const>) override { return kept().list.size() == 2 * added_.size(); }

    void add_section_forces(int element, double side, SectionForces& forces) const override {
        const int first = first_of(element);
        if ((side > 0) != (element == first)) return;
        const Eigen::Vector2d m = middle_moment(first, w_.state.force, w_.state);
        forces.Mx += m.x(), forces.My += m.y();
    }

private:
    static constexpr double at_once = 1e30;  ///< rad/s, of a pair without mass
    static constexpr double near = 0.25;     ///< of f_y in the middle: half of the plastic moment

    /// Eight elements, which are four pairs.
    struct Block {
        Lanes flexible[2] = {};                ///< l^2/EI in the two planes, 1/N; 0 where it is in no pair
        beam::PairShear<Lanes> shear[2] = {};  ///< of beam::softened_by_shear
        Lanes p(int plane, const Lanes& P) const {
            return beam::softened_by_shear<Lanes>(flexible[plane] * P, shear[plane]);
        }
        Lanes omega[2] = {};    ///< of the first bending vibration of the pair between pins, rad/s
        Lanes nothing[2] = {};  ///< a moment that is taken as none, N m
        Lanes point = {};       ///< the elements' integration points, -1 to 1
        Lanes yield[4] = {};    ///< of the law's screen for Mx, My, N, Mz; 0 without a law
    };
    /// Forces of the elements of a block.
    struct Forces {
        Forces(const Bow& bow, int block, const std::vector<Vec6>& force, const std::vector<beam::FixedEnd>& all) {
            const int from = block * lane_count, count = std::min(lane_count, int(force.size()) - from);
            transpose_rows<6>(force[from].data(), count, p);
            Lanes fixed[lane_count];
            transpose_rows<8>(all[from].moment, count, fixed);
            P = bow.compression(from, count, p[4]);
            for (int plane : {0, 1})
                middle[plane] =
                    even_and_odd(p[2 * plane + 1] + fixed[2 * plane + 1], -(p[2 * plane] + fixed[2 * plane]));
            const Lanes N = p[4] + even_and_odd(fixed[5], fixed[4]), Mz = p[5] + even_and_odd(fixed[7], fixed[6]);
            const Lanes(&y)[4] = bow.blocks_[block].yield;
            f = y[0] * middle[0] * middle[0] + y[1] * middle[1] * middle[1] + y[2] * N * N + y[3] * Mz * Mz;
            for (int i = 0; !bow.w_.trial.heat.empty() && i < count; ++i) {
                const double strength = bow.w_.trial.heat[std::size_t(from + i)].strength;
                f[i] /= strength * strength;
            }
        }
        Lanes p[lane_count];
        Lanes P;          ///< compression of the pairs over what heat leaves of E, N; 0 where one is broken
        Lanes middle[2];  ///< moments in the middle of the pair about x and about y, N m
        Lanes f;          ///< f_y there
    };
    const BowMoments& kept() const { return *w_.state.data.find<BowMoments>("bow"); }
    static int first_of(int element) { return element & ~1; }
    /// Where `force_of_fixed_ends` belongs to.
    const Pose& place() const { return w_.kind.dynamic ? static_cast<const Pose&>(w_.state) : w_.trial; }
    /// Whether all elements of a block belong to bodies at rest.
    bool rests(int block) const {
        if (w_.resting.empty()) return false;
        const auto& elements = w_.structure.elements();
        const std::size_t from = std::size_t(block) * lane_count, end = std::min(from + lane_count, elements.size());
        for (std::size_t i = from; i < end; i += 2)
            if (!w_.rests(elements[i].node[0])) return false;
        return true;
    }
    bool whole(int first) const { return !w_.state.broken[first] && !w_.state.broken[first + 1]; }

    /// From the axial forces of elements.
    Lanes compression(int from, int count, const Lanes& N) const {
        Lanes P = -0.5 * (N + neighbours(N));
        for (int i = 0; i < lane_count; i += 2) {
            if (!(i + 1 < count && whole(from + i))) P[i] = P[i + 1] = 0;
            else if (!w_.trial.heat.empty()) P[i] = P[i + 1] = P[i] / w_.trial.heat[std::size_t(from + i)].stiffness;
        }
        return P;
    }
    double compression(int first, const std::vector<Vec6>& force) const {
        return whole(first) ? -0.5 * (force[first][4] + force[first + 1][4]) / heat_of(w_.trial.heat, first).stiffness
                            : 0;
    }
    bool counts(int block, const std::vector<Vec6>& force) const {
        const int from = block * lane_count, count = std::min(lane_count, int(force.size()) - from);
        Lanes N = {};
        for (int i = 0; i < count; ++i) N[i] = force[from + i][4];
        const Lanes P = compression(from, count, N);
        for (int plane : {0, 1}) {
            const Lanes p = blocks_[block].p(plane, P);
            if (any_above(p < 0 ? -p : p, counts_from)) return true;
        }
        return false;
    }

    void add_to_block(int block, const Forces& of, const std::vector<Vec6>& force, const Pose& at, double factor,
                      std::vector<beam::FixedEnd>& all) const {
        const Block& b = blocks_[block];
        const int from = block * lane_count, count = std::min(lane_count, int(force.size()) - from);
        const Lanes p[2] = {b.p(0, of.P), b.p(1, of.P)};
        // the two elements of a pair have the same p: the even lanes compute one plane, the odd lanes the other
        const Lanes bow = beam::bow_of_moment<Lanes>(counted(even_and_odd(p[0], p[1])));
        Lanes more[2] = {moment_of_pairs(b, of, 0) * evens(bow), moment_of_pairs(b, of, 1) * odds(bow)};
        for (int i = 0; i + 1 < count; i += 2) {
            if (!(std::max(p[0][i], p[1][i]) > beam::bow_by_moments)) continue;
            const Eigen::Vector2d m = middle_moment(from + i, force, place());
            for (int plane : {0, 1}) more[plane][i] = more[plane][i + 1] = m[plane];
        }
        if (w_.kind.dynamic)
            for (int plane : {0, 1}) more[plane] = limited(more[plane], of.middle[plane]);
        for (int i = 0; i + 1 < count; i += 2) {
            if (!(of.f[i] > near && of.f[i + 1] > near)) continue;
            const Eigen::Vector2d m(more[0][i], more[1][i]);
            const Eigen::Vector2d peak = beyond_middle(from + i, {p[0][i], p[1][i]}, m, force, at, factor, all);
            for (int plane : {0, 1}) more[plane][i] = more[plane][i + 1] = m[plane] + peak[plane];
        }
        if (w_.kind.dynamic)
            for (int plane : {0, 1}) more[plane] = followed(block, plane, more[plane]);
        for (int i = 0; i + 1 < count; i += 2) {
            Eigen::Vector2d& added = added_[std::size_t((from + i) / 2)];
            if (!whole(from + i)) continue;
            added = {more[0][i], more[1][i]};
            for (int k : {0, 1}) add_to(from + i + k, added, all[from + i + k]);
        }
    }
    /// Mean of the moments at the two integration points, N m.
    static Lanes moment_of_pairs(const Block& b, const Forces& of, int plane) {
        const Lanes G = 0.5 * ((b.point - 1) / 2 * of.p[2 * plane] + (b.point + 1) / 2 * of.p[2 * plane + 1]);
        return G + neighbours(G);
    }

    bool has_kept(int block) const {
        const std::vector<double>& list = kept().list;
        const std::size_t from = std::size_t(block) * lane_count, end = std::min(from + lane_count, list.size());
        return w_.kind.dynamic && std::any_of(list.begin() + from, list.begin() + end, [](double m) { return m != 0; });
    }
    /// In dynamics a bow follows an axial force no faster than the pair bends: the waves along a bar that yields would
    /// otherwise make it flow to and fro in each step.
    Lanes followed(int block, int plane, const Lanes& now) const {
        const Block& b = blocks_[block];
        const double* list = &kept().list[std::size_t(block * lane_count)];
        Lanes before;
        for (int i = 0; i < lane_count; ++i) before[i] = list[i / 2 * 2 + plane];
        const Lanes by = b.omega[plane] * w_.assembly.step(), m = before + (now - before) * by / (1 + by);
        return (m < 0 ? -m : m) > b.nothing[plane] ? m : Lanes{};
    }

    /// In dynamics the moment follows the step before. Where it were larger than that of the elements, flow in a step
    /// would be more than undone in the next: compression beyond Euler's load of a pinned pair.
    static Lanes limited(const Lanes& m, const Lanes& in_middle) {
        constexpr double part = 0.5;  // 0.43 at 0.9, 0.50 at 0.99 of a pinned pair
        const Lanes sum = part * 0.5 * (in_middle + neighbours(in_middle)), most = sum < 0 ? -sum : sum,
                    below = m > most ? most : m;
        return below < -most ? -most : below;
    }

    /// Difference of the largest moment of a pair's span and the one in the middle, about x and about y, where both
    /// sides of the middle come near to the plastic one. `m`: the bow's part there.
    Eigen::Vector2d beyond_middle(int first, const Eigen::Vector2d& p, const Eigen::Vector2d& m,
                                  const std::vector<Vec6>& force, const Pose& at, double factor,
                                  const std::vector<beam::FixedEnd>& all) const {
        Eigen::Vector2d peak = Eigen::Vector2d::Zero();
        if (!w_.structure.elements()[first].law) return peak;
        const Vec6 before = force[first] + all[first].at(1), after = force[first + 1] + all[first + 1].at(-1),
                   begin = force[first] + all[first].at(-1), end = force[first + 1] + all[first + 1].at(1);
        for (int plane : {0, 1}) {
            if (!(std::abs(p[plane]) > counts_in_full)) continue;
            peak[plane] = beam::bow_peak(std::min(p[plane], beam::pair_most), -begin[2 * plane],
                                         0.5 * (before[2 * plane + 1] - after[2 * plane]) + m[plane],
                                         end[2 * plane + 1], host_.points_on_pair(first, plane, at, factor));
        }
        return peak;
    }

    /// The moment at an element's integration point, of those that its forces have, N m.
    double moment_at_point(int element, int plane, const std::vector<Vec6>& force) const {
        const Vec6& p = force[element];
        return beam::moment_at(p[2 * plane], p[2 * plane + 1], -w_.structure.elements()[element].s);
    }

    /// Difference of the moments of a pair's middle section and its elements' moments there, about x and about y, N m.
    Eigen::Vector2d middle_moment(int first, const std::vector<Vec6>& force, const Pose& at) const {
        Eigen::Vector2d m = Eigen::Vector2d::Zero();
        const auto& elements = w_.structure.elements();
        if (first + 1 >= int(elements.size()) || elements[first].partner != first + 1 || !whole(first)) return m;
        const double P = compression(first, force);
        for (int plane : {0, 1}) {
            const double p = counted(beam::pressed_pair(pair_kind_of(elements[first]), plane, P));
            if (p == 0 || !std::isfinite(p)) continue;
            if (p <= beam::bow_by_moments) {
                const double G =
                    0.5 * (moment_at_point(first, plane, force) + moment_at_point(first + 1, plane, force));
                m[plane] = G * beam::bow_of_moment(p);
                continue;
            }
            double K = 0;
            for (int i : {first, first + 1}) {
                const Vec6 d = element_deformation(w_.structure, i, at) - w_.state.plastic[i];
                K += 0.5 * (d[2 * plane + 1] - d[2 * plane]);
            }
            const double EI = plane == 0 ? elements[first].rigidity.EIx : elements[first].rigidity.EIy;
            m[plane] = heat_of(at.heat, first).stiffness * EI / elements[first].length * K * beam::bow_of_rotation(p);
        }
        return m;
    }

    /// At the end that an element has in the middle of its pair.
    static void add_to(int element, const Eigen::Vector2d& m, beam::FixedEnd& to) {
        to.add(element % 2 == 0 ? 1 : 0, m.x(), m.y(), 0, 0);
    }

    std::vector<Block> blocks_;
    mutable bool any_added_ = false;              ///< add_fixed_ends has been called for the present step
    mutable std::vector<Eigen::Vector2d> added_;  ///< of each pair, what add_fixed_ends added last, N m
};

}  // namespace

EffectKind bow_kind() {
    return {.name = "bow", .make = [](Workspace& w, Host& host) -> std::unique_ptr<Effect> {
                if (!w.structure.p_delta()) return nullptr;
                return std::make_unique<Bow>(w, host);
            }};
}

}  // namespace hinge
