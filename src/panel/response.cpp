#include "panel/response.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace hinge::panel {
namespace {

using Vec7 = Eigen::Matrix<double, own_strains, 1>;
using Mat7 = Eigen::Matrix<double, own_strains, own_strains>;
using Mat3x17 = Eigen::Matrix<double, 3, 17>;

constexpr int most_rounds = 40, most_cuts = 10;
constexpr double settled = 1e-6;    ///< of the membrane forces: what its own strains may leave
constexpr double supported = 1e-4;  ///< of the elastic stiffness, which a cracked section is given in the search
constexpr double seen = 1e-3;       ///< the same, in the stiffness that others see

/// What is added up over the layers at one point.
struct AtPoint {
    Vec3 stress = Vec3::Zero(), moment = Vec3::Zero();  ///< N/m, N
    SectionTangent tangent;
    double size = 0;  ///< of the layers' stresses, N/m
};

/// The layers at a point. `curved`: null without bending. With it concrete has its law in Green's strain: its strains
/// are those of compression, of which half a square is small beside them.
AtPoint add_layers(const Sheet& sheet, double area, const Vec3& strain, const Vec3* curved, bool large,
                   std::uint8_t gone, bool with_tangent, const double* before, double* after, PanelResponse& e) {
    AtPoint p;
    const bool stretches = sheet.has_solid() || (!curved && !sheet.has_bars_alone());
    const Strained middle(strain, large, stretches);
    for (std::size_t l = 0; l < sheet.layers.size(); ++l) {
        const Layer& layer = sheet.layers[l];
        const int size = layer.history_size() / int(layer.levels.size());
        const bool green = curved && layer.kind == LayerKind::concrete;
        for (const Level& level : layer.levels) {
            const double* const from = before;
            double* const to = after;
            before += size, after += size;
            if (gone >> l & 1) {
                std::copy_n(from, size, to);
                continue;
            }
            const bool off = curved && level.z != 0;
            const Vec3 here = off ? Vec3(strain - level.z * *curved) : strain;
            const Response r =
                respond(layer, off || green ? Strained(here, large && !green, stretches && !green) : middle, from, to,
                        with_tangent);
            const Vec3 stress = level.part * r.stress;
            p.stress += stress;
            if (off) p.moment -= level.z * stress;
            p.size += stress.lpNorm<1>();
            if (with_tangent) p.tangent.add(level.part * r.tangent, off ? level.z : 0);
            const double share = area * level.part;
            e.stored += share * r.stored, e.dissipated += share * r.dissipated;
            e.stored_in[l] += share * r.stored;
            e.used = std::max(e.used, r.used);
            if (r.used >= 1) e.tears |= std::uint8_t(1u << l);
        }
    }
    return p;
}

Mat3x17 strain_at(const Point& point) {
    Mat3x17 T = Mat3x17::Zero();
    T.leftCols<3>().setIdentity(), T.middleCols<2>(3) = point.P;
    return T;
}

void add_section(const Point& point, int k, const SectionTangent& t, Mat17& sum) {
    const Mat3x17 T = strain_at(point);
    const auto own = Eigen::seqN(5 + 3 * k, 3);
    const Mat3x17 of = point.area * (t.coupling * T);
    sum += point.area * (T.transpose() * t.membrane * T);
    sum(own, Eigen::all) += of;
    sum(Eigen::all, own) += of.transpose();
    sum(own, own) += point.area * t.bending;
}

/// A panel that bends by its layers, with the strains of its own that leave it membrane forces of its five forms.
class Bent4 {
public:
    Bent4(const Sheet& sheet, const Shape& shape, const Placed& at, std::uint8_t gone, const Bending& bending,
          const double* before, double* after)
        : sheet_(sheet),
          shape_(shape),
          at_(at),
          gone_(gone),
          bending_(bending),
          before_(before),
          after_(after),
          size_(sheet.history_size()) {}

    PanelResponse find() {
        own_ = Eigen::Map<const Vec7>(before_ + 4 * size_);
        evaluate(true);
        bool has_tangent = true;
        for (int round = 0; round < most_rounds && left_.norm() > settled * size_of_forces_; ++round) {
            if (!has_tangent) evaluate(true);
            // the energy is convex: along the step its slope rises, from below zero
            const Vec7 step = -stiffness(supported).ldlt().solve(left_), from = own_;
            const double slope = left_.dot(step);
            double low = 0, at_low = slope, high = 0, at_high = 0, part = 1;
            for (int cut = 0; cut < most_cuts; ++cut) {
                own_ = from + part * step;
                evaluate(false);
                const double now = left_.dot(step);
                if (std::abs(now) <= 0.5 * std::abs(slope)) break;
                if (now < 0) low = part, at_low = now;
                else high = part, at_high = now;
                if (high == 0) part *= 2;
                else part = cut % 2 == 0 ? low + (high - low) * at_low / (at_low - at_high) : 0.5 * (low + high);
            }
            has_tangent = false;
        }
        Eigen::Map<Vec7>(after_ + 4 * size_) = own_;
        if (bending_.tangent) {
            if (!has_tangent) evaluate(true);
            condense();
        }
        e_.left = left_.norm() / size_of_forces_;
        return e_;
    }

private:
    void evaluate(bool with_tangent) {
        e_ = {};
        left_.setZero(), size_of_forces_ = 1e-5 * bending_.own->elastic.trace() * shape_.area;
        for (int k = 0; k < 4; ++k) {
            const Point& point = shape_.point[k];
            const Mat37& A = bending_.own->at[std::size_t(k)];
            const Vec3 strain = at_.strain + point.P * at_.p + A * own_;
            points_[k] = add_layers(sheet_, point.area, strain, &(*bending_.curved)[std::size_t(k)], at_.large, gone_,
                                    with_tangent, before_ + k * size_, after_ + k * size_, e_);
            const Vec3 of = point.area * points_[k].stress;
            left_ += A.transpose() * of;
            size_of_forces_ += point.area * points_[k].size * A.norm();
            e_.resultants.mean += of, e_.resultants.varying += point.P.transpose() * of;
            e_.moment[std::size_t(k)] = point.area * points_[k].moment;
        }
    }
    Mat7 stiffness(double part) const {
        Mat7 sum = Mat7::Zero();
        for (int k = 0; k < 4; ++k) {
            const Mat37& A = bending_.own->at[std::size_t(k)];
            sum += shape_.point[k].area *
                   (A.transpose() * (points_[k].tangent.membrane + part * bending_.own->elastic) * A);
        }
        return sum;
    }
    void condense() const {
        Mat17& H = *bending_.tangent;
        H.setZero();
        Eigen::Matrix<double, own_strains, 17> across = Eigen::Matrix<double, own_strains, 17>::Zero();
        for (int k = 0; k < 4; ++k) {
            const SectionTangent& t = points_[k].tangent;
            add_section(shape_.point[k], k, t, H);
            Mat3x17 of = t.membrane * strain_at(shape_.point[k]);
            of.middleCols<3>(5 + 3 * k) += t.coupling;
            across += shape_.point[k].area * (bending_.own->at[std::size_t(k)].transpose() * of);
        }
        H -= across.transpose() * stiffness(seen).ldlt().solve(across);
    }

    const Sheet& sheet_;
    const Shape& shape_;
    const Placed& at_;
    std::uint8_t gone_;
    const Bending& bending_;
    const double* before_;
    double* after_;
    int size_;
    PanelResponse e_;
    AtPoint points_[4];
    Vec7 own_, left_;
    double size_of_forces_ = 0;
};

}  // namespace

OwnStrains own_strains_of(const Sheet& sheet, const Shape& s) {
    Eigen::Matrix<double, 12, 5> forms;
    for (int k = 0; k < 4; ++k) {
        const double root = std::sqrt(s.point[k].area);
        forms.block<3, 3>(3 * k, 0) = root * Mat3::Identity();
        forms.block<3, 2>(3 * k, 3) = root / s.area * s.point[k].S;
    }
    const Eigen::Matrix<double, 12, 12> Q = forms.householderQr().householderQ();
    OwnStrains own{{}, sheet.elastic().membrane};
    for (int k = 0; k < 4; ++k)
        own.at[std::size_t(k)] = std::sqrt(s.area / s.point[k].area) * Q.block<3, own_strains>(3 * k, 5);
    return own;
}

void add_point(const Point& point, const Mat3& D, Mat5& sum) {
    const Mat3 of = point.area * D;
    sum.topLeftCorner<3, 3>() += of;
    sum.topRightCorner<3, 2>() += of * point.P;
    sum.bottomLeftCorner<2, 3>() += point.P.transpose() * of;
    sum.bottomRightCorner<2, 2>() += point.P.transpose() * of * point.P;
}

Mat17 stiffest(const Shape& shape, const SectionTangent& section) {
    Mat17 sum = Mat17::Zero();
    for (int k = 0; k < shape.points; ++k) add_section(shape.point[k], k, section, sum);
    return sum;
}

int history_size(const Sheet& sheet, const Shape& shape) {
    return sheet.history_size() * shape.points + (sheet.bends_by_layers ? own_strains : 0);
}

PanelResponse respond(const Sheet& sheet, const Shape& shape, const Placed& at, std::uint8_t gone, bool with_tangent,
                      const Bending& bending, const double* before, double* after) {
    if (bending.curved) return Bent4(sheet, shape, at, gone, bending, before, after).find();
    PanelResponse e;
    const int size = sheet.history_size();
    for (int k = 0; k < shape.points; ++k) {
        const Point& point = shape.point[k];
        const AtPoint p = add_layers(sheet, point.area, at.strain + point.P * at.p, nullptr, at.large, gone,
                                     with_tangent, before + k * size, after + k * size, e);
        e.resultants.mean += point.area * p.stress;
        for (int a : {0, 1}) e.resultants.varying[a] += point.area * point.P.col(a).dot(p.stress);
        if (with_tangent) add_point(point, p.tangent.membrane, e.tangent);
    }
    return e;
}

}  // namespace hinge::panel
