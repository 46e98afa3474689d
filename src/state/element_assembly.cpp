#include "state/element_assembly.h"

#include <algorithm>
#include <map>

#include "beam/element_mass.h"
#include "core/built.h"
#include "state/element_block.h"
#include "state/hinges.h"

namespace hinge {

ElementAssembly::ElementAssembly(const Structure& structure, ThreadPool& pool, bool inertia)
    : structure_(structure), pool_(pool), inertia_(inertia) {}

ElementAssembly::~ElementAssembly() = default;

int ElementAssembly::sections(double* r) const {
    if (structure_.conventional()) return r[0] = 0, 1;
    return r[0] = -1, r[1] = 1, 2;
}

void ElementAssembly::mark_built(int element, const State& state, const Configuration& pose) {
    if (!watching_) return;
    const ElementFrame place = element_frame(structure_, element, pose);
    const Mat3 frame = axes_of(place);
    const int i = element % lane_count;
    Lanes* built = &built_[built_stride() * std::size_t(element / lane_count)];
    for (int c = 0; c < 3; ++c) built[c][i] = frame(c, 2), built[3 + c][i] = frame(c, 1);
    if (!structure_.p_delta()) return;
    const Vec6 d = element_deformation(structure_, element, pose, place) - state.plastic[element];
    built[6][i] = d[1] - d[0], built[7][i] = d[3] - d[2];
}

void ElementAssembly::watch_rotation(double tolerance) {
    watching_ = true;
    rotation_limit_ = tolerance * tolerance;
    built_.assign(built_stride() * blocks_.size(), Lanes{});
}

void ElementAssembly::update_active(const State& state) {
    const int count = int(state.broken.size());
    blocks_.resize((count + lane_count - 1) / lane_count);
    kinds_.clear();
    std::map<std::array<const void*, lane_count>, const Kind*> known;
    for (int block = 0; block < int(blocks_.size()); ++block) {
        Block& b = blocks_[block];
        b.whole = 0;
        std::array<const void*, lane_count> alike;
        bool as_declared = true;
        int index[lane_count];
        for (int i = 0; i < lane_count; ++i) {
            index[i] = std::min(block * lane_count + i,
                                count - 1);  // a short block repeats its last element and drops the copies
            const Element& e = structure_.elements()[index[i]];
            alike[i] = &e.stiffness;
            as_declared = as_declared && state.point[index[i]] == e.s;
            b.node[0][i] = e.node[0];
            b.node[1][i] = e.node[1];
            for (int c = 0; c < 3; ++c) b.chord[c][i] = e.chord[c];
            if (block * lane_count + i < count && !state.broken[index[i]]) b.whole |= 1u << i;
        }
        if (as_declared) {
            const Kind*& kind = known[alike];
            if (!kind) kind = &add_kind(state, index);
            b.kind = kind;
        } else {
            b.kind = &add_kind(state, index);
        }
    }
}

const ElementAssembly::Kind& ElementAssembly::add_kind(const State& state, const int* index) {
    kinds_.emplace_back();
    Kind& kind = kinds_.back();
    kind.can_yield = kind.moves_surface = kind.takes_shear = kind.wears_stiffness = false;
    for (int i = 0; i < lane_count; ++i) {
        const Element& e = structure_.elements()[index[i]];
        const beam::Stiffness k = declared_stiffness(structure_, state, index[i]);
        kind.length[i] = e.length;
        const double q[4] = {e.axes.w(), e.axes.x(), e.axes.y(), e.axes.z()};
        for (int c = 0; c < 4; ++c) kind.axes[c][i] = q[c];
        const double ks[8] = {k.x11, k.x12, k.x22, k.y11, k.y12, k.y22, k.axial, k.twist};
        for (int c = 0; c < 8; ++c) kind.k[c][i] = ks[c];
        const beam::YieldSurface screen = e.law ? e.law->screen() : beam::YieldSurface{};
        const double w[4] = {screen.x, screen.y, screen.n, screen.z};
        for (int c = 0; c < 4; ++c) kind.yield[c][i] = w[c];
        kind.mass[i] = e.mass() / 6;
        const Vec3 rotary = beam::rotary_inertia(e.rigidity) * (e.length / 6);
        for (int c = 0; c < 3; ++c) kind.rotary[c][i] = rotary[c];
        const beam::Inertia linear = beam::linear_inertia(e.rigidity, e.length), whole = structure_.inertia(index[i]);
        for (int end : {0, 1}) {
            kind.more[end][i] = whole.own[end] - linear.own[end];
            kind.more_rotary[end][i] = whole.rotary[end].x() - linear.rotary[end].x();
        }
        kind.more_across[i] = whole.across - linear.across;
        if (structure_.p_delta()) {
            const beam::PairKind<double> pair = pair_kind_of(e);
            kind.pair.axial[i] = pair.axial, kind.pair.length[i] = pair.length;
            for (int plane : {0, 1}) {
                kind.pair.b[plane][i] = pair.b[plane], kind.pair.c[plane][i] = pair.c[plane];
                beam::put(kind.pair.shear[plane], i, pair.shear[plane]);
            }
        }
        kind.can_yield |= e.law != nullptr;
        kind.moves_surface |= e.law && e.law->moves_surface();
        kind.takes_shear |= e.law && e.law->takes_shear();
        kind.wears_stiffness |= e.law && e.law->wears_stiffness();
    }
    return kind;
}

void ElementAssembly::activate(int element) { blocks_[element / lane_count].whole |= 1u << element % lane_count; }

void ElementAssembly::deactivate(int element) {
    blocks_[element / lane_count].whole &= ~(1u << element % lane_count);
    if (shared_index_.empty()) return;
    for (int e : {0, 1})
        if (const int place = shared_index_[2 * element + e]; place >= 0) shared_forces_[place].setZero();
}

std::vector<std::uint8_t> ElementAssembly::active_bits() const {
    std::vector<std::uint8_t> whole;
    for (const Block& b : blocks_) whole.push_back(std::uint8_t(b.whole));
    return whole;
}

std::vector<double> ElementAssembly::frames() const {
    const auto* first = reinterpret_cast<const double*>(built_.data());
    return {first, first + built_.size() * lane_count};
}

/// False, and nothing has changed, where somebody would take part who is broken or not there.
bool ElementAssembly::restore_active(const std::vector<std::uint8_t>& whole, const std::vector<double>& built) {
    if (whole.size() != blocks_.size() || built.size() != built_.size() * lane_count) return false;
    for (std::size_t i = 0; i < whole.size(); ++i)
        if (whole[i] & ~blocks_[i].whole) return false;
    for (std::size_t i = 0; i < whole.size(); ++i) blocks_[i].whole = whole[i];
    std::copy(built.begin(), built.end(), reinterpret_cast<double*>(built_.data()));
    for (Vec6& l : shared_forces_) l.setZero();
    return true;
}

/// Which nodes have elements in more than one piece.
void ElementAssembly::share_out() {
    shared_index_.assign(2 * structure_.elements().size(), -1);
    const auto piece_of = [](int element) { return element / (piece * lane_count); };
    for (int node = 0; node < int(structure_.position().size()); ++node) {
        const std::span<const int> at = structure_.elements_at(node);
        if (at.empty() || piece_of(at.front()) == piece_of(at.back())) continue;
        const int first = int(shared_forces_.size());
        for (int e : at) {
            shared_index_[2 * e + (structure_.elements()[e].node[0] == node ? 0 : 1)] = int(shared_forces_.size());
            shared_forces_.push_back(Vec6::Zero());
        }
        shared_.push_back({node, first, int(shared_forces_.size())});
    }
}

Failure ElementAssembly::failure(bool nothing_breaks) const {
    if (folded_ >= 0)
        return {.cause = Cause::element_folded,
                .element = folded_,
                .unbroken = nothing_breaks && !structure_.elements()[folded_].yield.elastic()};
    if (unreturned_ >= 0) return {.cause = Cause::flow_not_found, .element = unreturned_};
    return {};
}

}  // namespace hinge
