#include "panel/sheet.h"

#include <algorithm>
#include <cmath>

#include "panel/principal.h"

namespace hinge::panel {
namespace {

/// Elastic, per thickness, Pa; concrete: that under compression.
Mat3 stiffness_of(const Layer& l) {
    const double nu = l.kind == LayerKind::solid ? l.poisson : 0, k = l.E / (1 - nu * nu);
    return (Mat3() << k, nu * k, 0, nu * k, k, 0, 0, 0, 0.5 * (1 - nu) * k).finished();
}

/// What a layer's own law gives, in its own measure of strain.
struct Law {
    Vec3 stress = Vec3::Zero();
    Mat3 tangent = Mat3::Zero();
    double stored = 0, dissipated = 0, used = 0;
};

/// Plane stress, von Mises, isotropic linear hardening: the strain returns to the yield surface along its normal at the
/// end (Simo and Hughes, Computational Inelasticity, 1998, section 3.4). Kept: plastic strain, its equivalent, stress.
void solid(const Layer& l, const Vec3& strain, const double* before, double* after, bool with_tangent, Law& law) {
    const Mat3 D = stiffness_of(l);
    const Eigen::Map<const Vec3> plastic(before), stress_before(before + 4);
    Vec3 stress = D * (strain - plastic), flow = Vec3::Zero();
    double alpha = before[3];
    const double E1 = l.E / (3 * (1 - l.poisson)), G2 = l.E / (1 + l.poisson);  // of the sum, of difference and shear
    const double sum = stress[0] + stress[1], difference = stress[1] - stress[0];
    // f^2 = s P s of the stress that has flowed by `by`
    const auto size2 = [&](double by) {
        const double a = sum / (1 + E1 * by), b = difference / (1 + G2 * by), c = stress[2] / (1 + G2 * by);
        return a * a / 6 + b * b / 2 + 2 * c * c;
    };
    const auto strength_at = [&](double by) {
        return l.strength + l.hardening * (before[3] + std::sqrt(2.0 / 3) * by * std::sqrt(size2(by)));
    };
    Mat3 tangent = D;
    if (std::isfinite(l.strength) && 1.5 * size2(0) > strength_at(0) * strength_at(0)) {
        // the difference falls with `by`: bisection, then secants inside of the bracket
        const auto beyond = [&](double by) { return std::sqrt(1.5 * size2(by)) - strength_at(by); };
        double low = 0, high = (std::sqrt(1.5 * size2(0)) / l.strength) / std::min(E1, G2) + 1e-300;
        while (beyond(high) > 0) high *= 2;
        double at_low = beyond(low), at_high = beyond(high), by = high;
        for (int i = 0; i < 100 && high - low > 1e-15 * high; ++i) {
            by = i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * at_low / (at_low - at_high);
            const double now = beyond(by);
            if (now > 0) low = by, at_low = now;
            else high = by, at_high = now;
            if (std::abs(now) < 1e-14 * l.strength) break;
        }
        const double a = sum / (1 + E1 * by), b = difference / (1 + G2 * by), c = stress[2] / (1 + G2 * by);
        stress = {(a - b) / 2, (a + b) / 2, c};
        const Mat3 P = (Mat3() << 2, -1, 0, -1, 2, 0, 0, 0, 6).finished() / 3;
        flow = by * (P * stress);
        const double f2 = stress.dot(P * stress);
        alpha += std::sqrt(2.0 / 3) * by * std::sqrt(f2);
        if (with_tangent) {
            const Mat3 X = (D.inverse() + by * P).inverse();
            const Vec3 n = X * (P * stress);
            const double theta = 1 - 2.0 / 3 * l.hardening * by, beta = 2.0 / 3 / theta * l.hardening * f2;
            tangent = X - n * n.transpose() / (stress.dot(P * n) + beta);
        }
    }
    Eigen::Map<Vec3>(after, 3) = plastic + flow;
    after[3] = alpha;
    const Vec3 elastic = strain - plastic - flow;
    law.dissipated = 0.5 * (stress_before + stress).dot(flow);
    Eigen::Map<Vec3>(after + 4, 3) = stress;
    law.stress = stress, law.tangent = tangent;
    law.stored = 0.5 * stress.dot(elastic);
    law.used = alpha / l.ultimate;
}

/// No tension, and a constant crushing strength, in each principal direction of the strain less what was crushed. Kept:
/// the crushed strain, stress.
void concrete(const Layer& l, const Vec3& strain, const double* before, double* after, bool with_tangent, Law& law) {
    const Eigen::Map<const Vec3> crushed(before), stress_before(before + 3);
    const Vec3 e = strain - crushed;
    const Principal axes(e);
    Vec3 flow = Vec3::Zero(), of[2];
    double s[2], principal[2] = {axes.middle + axes.half, axes.middle - axes.half}, stiffness[2];
    for (int i : {0, 1}) {
        of[i] = axes.direction(i);
        s[i] = l.E * std::min(principal[i], 0.0), stiffness[i] = principal[i] > 0 ? 0 : l.E;
        if (s[i] < -l.strength) {
            const double by = principal[i] + l.strength / l.E;
            s[i] = -l.strength, stiffness[i] = 0;
            flow += by * Vec3(of[i][0], of[i][1], 2 * of[i][2]);
        }
        law.stress += s[i] * of[i];
        if (with_tangent) law.tangent += stiffness[i] * of[i] * of[i].transpose();
        law.stored += 0.5 * s[i] * s[i] / l.E;
    }
    if (with_tangent) {  // the axes rotate with the strain
        const Vec3 across = axes.across();
        const double shear = axes.half > 1e-12 ? (s[0] - s[1]) / (4 * axes.half) : 0.25 * (stiffness[0] + stiffness[1]);
        law.tangent += shear * across * across.transpose();
    }
    Eigen::Map<Vec3>(after, 3) = crushed + flow;
    Eigen::Map<Vec3>(after + 3, 3) = law.stress;
    law.dissipated = 0.5 * (stress_before + law.stress).dot(flow);
}

/// Along their direction. Kept: plastic strain, its sum, force.
Law bars(const Layer& l, double strain, const double* before, double* after, double& force, double& slope) {
    Law law;
    double plastic = before[0], sum = before[1];
    force = l.E * (strain - plastic), slope = l.E;
    const double strength = l.strength + l.hardening * sum;
    if (std::abs(force) > strength) {
        const double by = (std::abs(force) - strength) / (l.E + l.hardening);
        plastic += std::copysign(by, force), sum += by;
        force = std::copysign(strength + l.hardening * by, force);
        slope = l.E * l.hardening / (l.E + l.hardening);
    }
    law.stored = 0.5 * force * force / l.E;
    law.dissipated = 0.5 * (before[2] + force) * (plastic - before[0]);
    law.used = strain / l.ultimate;
    after[0] = plastic, after[1] = sum, after[2] = force;
    return law;
}

}  // namespace

Mat3 Layer::elastic() const {
    if (kind == LayerKind::bars) return E * thickness * direction * direction.transpose();
    return thickness * stiffness_of(*this);
}

int Layer::history_size() const {
    return int(levels.size()) * (kind == LayerKind::solid ? 7 : kind == LayerKind::concrete ? 6 : 3);
}

SectionTangent Sheet::elastic() const {
    SectionTangent sum;
    for (const Layer& l : layers)
        for (const Level& level : l.levels) sum.add(level.part * l.elastic(), level.z);
    return sum;
}
Sheet Sheet::linear() const {
    Sheet sheet = *this;
    for (Layer& l : sheet.layers) {
        if (l.kind == LayerKind::concrete) l.kind = LayerKind::solid, l.poisson = 0;
        l.strength = l.ultimate = std::numeric_limits<double>::infinity();
    }
    sheet.bending.sagging = sheet.bending.hogging = std::numeric_limits<double>::infinity();
    return sheet;
}
double Sheet::poisson() const {
    double nu = 0, most = 0;
    for (const Layer& l : layers)
        if (l.E * l.thickness > most) most = l.E * l.thickness, nu = l.kind == LayerKind::solid ? l.poisson : 0;
    return nu;
}
double Sheet::thickness() const {
    double most = 0;
    for (const Layer& l : layers)
        if (l.kind != LayerKind::bars) most = std::max(most, l.thickness);
    return most;
}
double Sheet::stiffness() const {
    double most = 0;
    for (const Layer& l : layers) most = std::max(most, l.E * l.thickness);
    return most;
}
int Sheet::history_size() const {
    int size = 0;
    for (const Layer& l : layers) size += l.history_size();
    return size;
}
bool Sheet::is_elastic() const {
    return std::all_of(layers.begin(), layers.end(), [](const Layer& l) { return l.is_elastic(); });
}

bool Sheet::has_solid() const {
    return std::any_of(layers.begin(), layers.end(), [](const Layer& l) { return l.kind == LayerKind::solid; });
}
bool Sheet::has_bars_alone() const {
    return std::all_of(layers.begin(), layers.end(), [](const Layer& l) { return l.kind == LayerKind::bars; });
}

Strained::Strained(const Vec3& strain, bool is_large, bool stretches)
    : green(strain), large(is_large), half(Symmetric{}), stretch(strain) {
    if (!stretches || !large) return;
    const Symmetric E = Symmetric::of_strain(strain), U = stretch_of(E);
    half = HalfOf(U);
    stretch = HalfOf({U.a + 1, U.b + 1, U.c})(E * 4).strain();
}

Response respond(const Layer& l, const Strained& at, const double* before, double* after, bool with_tangent) {
    Response r;
    Law law;
    if (l.kind == LayerKind::bars) {
        const Vec3 n = l.direction;
        const double green = n.dot(at.green), ratio = at.large ? std::sqrt(1 + 2 * green) : 1;
        double force = 0, slope = 0;
        law = bars(l, at.large ? 2 * green / (1 + ratio) : green, before, after, force, slope);
        r.stress = l.thickness * force / ratio * n;
        r.tangent = l.thickness * (slope / (ratio * ratio) - (at.large ? force / (ratio * ratio * ratio) : 0)) * n *
                    n.transpose();
    } else {
        if (l.kind == LayerKind::solid) solid(l, at.stretch, before, after, with_tangent, law);
        else concrete(l, at.stretch, before, after, with_tangent, law);
        if (!at.large) {
            r.stress = l.thickness * law.stress, r.tangent = l.thickness * law.tangent;
            r.stored = l.thickness * law.stored, r.dissipated = l.thickness * law.dissipated, r.used = law.used;
            return r;
        }
        const Symmetric X = at.half(Symmetric::of_stress(law.stress) * l.thickness);
        r.stress = (X * 2).stress();
        if (with_tangent) {
            Mat3 by_green;  // d(stretch)/d(Green's strain)
            for (int i = 0; i < 3; ++i) by_green.col(i) = at.half(Symmetric::of_strain(2 * Vec3::Unit(i))).strain();
            r.tangent = l.thickness * (by_green.transpose() * law.tangent * by_green);
            for (int i = 0; i < 3; ++i)  // d(by_green)
                r.tangent.col(i) -= 2 * at.half(both_ways(X, Symmetric::of_strain(by_green.col(i)))).stress();
        }
    }
    r.stored = l.thickness * law.stored, r.dissipated = l.thickness * law.dissipated, r.used = law.used;
    return r;
}

}  // namespace hinge::panel
