#include "algebra/condensed.h"

#include <algorithm>
#include <cmath>

#include "algebra/blocks.h"
#include "algebra/unfused.h"

namespace hinge {

using namespace blocks;

namespace {

constexpr int piece = 256;  // rows that one thread takes at a time

int other_node(const Element& e, int node) { return e.node[0] == node ? e.node[1] : e.node[0]; }
int end_at(const Element& e, int node) { return e.node[0] == node ? 0 : 1; }

template <class Number>
void put(Number* to, const Mat6& m) {
    for (int i = 0; i < 36; ++i) to[i] = Number(m.data()[i]);
}
template <class Number>
Mat6 get(const Number* from) {
    return Eigen::Map<const Eigen::Matrix<Number, 6, 6>>(from).template cast<double>();
}

/// q = D^-1 r at a place; returns the six products q r.
template <class Number>
[[gnu::always_inline]] inline Wide precondition(const Number* inverse, const double* r, double* q) {
    const Wide z = times(inverse, r);
    store(q, z);
    return Wide(six * z * load(r));
}

}  // namespace

template <class Number>
Condensed<Number>::Condensed(const Structure& structure, ThreadPool& pool) : structure_(structure), pool_(pool) {
    const int n = int(structure.position().size());
    which_.assign(n, -1);
    const auto at = [&](int node) { return structure.elements_at(node); };
    const auto could_go = [&](int i) { return at(i).size() <= 2; };
    int most = 0;
    for (int i = 0; i < n; ++i) most += could_go(i);
    between_.reserve(most);
    for (int i = n - 1; i >= 0; --i) {  // inner nodes come after the joints
        if (!could_go(i)) continue;
        CondensedNode m{i, 0, {-1, -1}, {-1, -1}, false, {}, {}};
        bool alone = true;
        for (int e : at(i)) {
            m.element[m.count] = e;
            m.side[m.count] = other_node(structure.elements()[e], i);
            alone = alone && which_[m.side[m.count]] < 0 && (m.count == 0 || m.side[0] != m.side[1]);
            ++m.count;
        }
        if (!alone) continue;
        which_[i] = int(between_.size());
        between_.push_back(m);
    }
    place_.assign(n, -1);
    for (int i = 0; i < n; ++i)
        if (which_[i] < 0) place_[i] = int(order_.size()), order_.push_back(i);
    paint();
    // a colour's rows lie together, as they are used
    std::vector<int> by_colour;
    by_colour.reserve(joints());
    for (Colour c : {Colour::red, Colour::black})
        for (int p = 0; p < joints(); ++p)
            if (colour_[p] == c) by_colour.push_back(order_[p]);
    std::stable_partition(colour_.begin(), colour_.end(), [](Colour c) { return c == Colour::red; });
    order_ = std::move(by_colour);
    row_begin_.assign(1, 0);
    for (int p = 0; p < joints(); ++p) {
        place_[order_[p]] = p;
        row_begin_.push_back(row_begin_.back() + 1 + int(at(order_[p]).size()));
    }
    lay_out();
}

/// Red, from each part's first node outwards: every node without a red neighbour.
template <class Number>
void Condensed<Number>::paint() {
    colour_.assign(order_.size(), Colour::between);
    std::vector<int> queue;
    const auto neighbours = [&](int place, auto visit) {
        const int node = order_[place];
        for (int e : structure_.elements_at(node)) {
            int next = other_node(structure_.elements()[e], node);
            if (which_[next] >= 0) {
                const CondensedNode& m = between_[which_[next]];
                if (m.count < 2) continue;
                next = m.side[m.side[0] == node ? 1 : 0];
            }
            visit(place_[next]);
        }
    };
    for (int start = 0; start < joints(); ++start) {
        if (colour_[start] != Colour::between) continue;
        queue.assign(1, start);
        colour_[start] = Colour::red;
        for (std::size_t i = 0; i < queue.size(); ++i)
            neighbours(queue[i], [&](int next) {
                if (colour_[next] != Colour::between) return;
                bool red = true;
                neighbours(next, [&](int p) { red = red && colour_[p] != Colour::red; });
                colour_[next] = red ? Colour::red : Colour::black;
                queue.push_back(next);
            });
    }
}

/// Where the column of a joint's entry lies: across the node between, if there is one and it is taken out.
template <class Number>
int Condensed<Number>::far(int place, int entry) const {
    const int node = order_[place],
              next = other_node(structure_.elements()[structure_.elements_at(node)[entry - 1]], node);
    if (place_[next] >= 0) return place_[next];
    const CondensedNode& m = between_[which_[next]];
    return m.count < 2 ? place : place_[m.side[m.side[0] == node ? 1 : 0]];
}

/// Lists of places and columns, as they are with what is coupled now.
template <class Number>
void Condensed<Number>::lay_out() {
    order_.resize(joints());
    row_begin_.resize(joints() + 1);
    for (CondensedNode& m : between_) m.excluded = false, place_[m.node] = -1;
    for (int node : coupled_)
        if (which_[node] >= 0) {
            between_[which_[node]].excluded = true;
            place_[node] = int(order_.size());
            order_.push_back(node);
            row_begin_.push_back(row_begin_.back() + 1 + between_[which_[node]].count);
        }
    const int places = int(order_.size());
    column_.resize(row_begin_.back());
    condensed_side_.resize(row_begin_.back());
    value_.resize(36 * std::size_t(row_begin_.back()) + 2);
    inverse_.resize(36 * std::size_t(places) + 2);
    for (auto* v : {&x_, &r_, &d_, &q_}) v->resize(stride * std::size_t(places));
    for (int p = 0; p < places; ++p) {
        const int node = order_[p];
        column_[row_begin_[p]] = p;
        condensed_side_[row_begin_[p]] = -1;
        for (int k = 1; k < row_begin_[p + 1] - row_begin_[p]; ++k) {
            column_[row_begin_[p] + k] = far(p, k);
            const int next = other_node(structure_.elements()[structure_.elements_at(node)[k - 1]], node);
            condensed_side_[row_begin_[p] + k] =
                place_[next] >= 0 ? -1 : 2 * which_[next] + (between_[which_[next]].side[0] == node ? 0 : 1);
        }
    }
    coupled_rows_.lay_out(places, coupled_pairs());
    take_couplings();
    red_.clear();
    black_.clear();
    staying_.clear();
    going_.clear();
    for (int i = 0; i < int(between_.size()); ++i)
        if (!between_[i].excluded && takes_part(between_[i].node)) going_.push_back(i);
    std::vector<char> is_red(places, 0);
    const auto stays_red = [&](int p) {  // what is coupled stays so where nothing it is coupled with does
        return p < joints() && colour_[p] == Colour::red &&
               !coupled_rows_.any_beside(p, [&](int other) { return is_red[other]; });
    };
    for (int p = 0; p < places; ++p) {
        if (!takes_part(order_[p])) continue;
        staying_.push_back(p);
        is_red[p] = stays_red(p);
        (is_red[p] ? red_ : black_).push_back(p);
    }
}

/// Places that couplings and bridges join.
template <class Number>
std::vector<CoupledRows::Pair> Condensed<Number>::coupled_pairs() const {
    std::vector<CoupledRows::Pair> pairs;
    pairs.reserve(couplings_.size() + bridges_.size());
    for (const Coupling& c : couplings_) pairs.push_back({place_[c.a], place_[c.b], c.is_light()});
    for (const Bridge& b : bridges_) pairs.push_back({place_[b.a], place_[b.b], false});
    return pairs;
}

template <class Number>
void Condensed<Number>::take_couplings() {
    coupled_rows_.set_zero();
    for (const Coupling& c : couplings_)
        for (int i : {0, 1})
            for (int j : {0, 1})
                coupled_rows_.add(place_[i ? c.b : c.a], place_[j ? c.b : c.a], c.K.template block<6, 6>(6 * i, 6 * j));
    for (const Bridge& b : bridges_) b.add_to(coupled_rows_, place_);
}

template <class Number>
void Condensed<Number>::leave_out(const std::vector<int>& resting) {
    resting_ = resting;
    lay_out();
}

template <class Number>
void Condensed<Number>::couple(const std::vector<Coupling>& couplings, std::vector<int>& changed) {
    const bool same_nodes = std::equal(couplings.begin(), couplings.end(), couplings_.begin(), couplings_.end(),
                                       [](const Coupling& c, const Coupling& d) { return c.a == d.a && c.b == d.b; });
    couplings_ = couplings;
    if (same_nodes && coupled_rows_.is_laid_out_for(coupled_pairs())) return take_couplings();
    std::vector<int> nodes;
    for (const Coupling& c : couplings) nodes.push_back(c.a), nodes.push_back(c.b);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const auto& list : {coupled_, nodes}) changed.insert(changed.end(), list.begin(), list.end());
    if (structure_.p_delta()) {  // outer nodes that a bridge joins are coupled, too
        for (std::size_t i = 0, n = nodes.size(); i < n; ++i)
            if (const int first = pair_about(nodes[i]); first >= 0) {
                nodes.push_back(structure_.elements()[first].node[0]);
                nodes.push_back(structure_.elements()[first + 1].node[1]);
            }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        changed.insert(changed.end(), nodes.begin(), nodes.end());
    }
    coupled_ = std::move(nodes);
    bridges_.clear();
    for (int node : coupled_)
        if (const int first = structure_.p_delta() ? pair_about(node) : -1; first >= 0)
            bridges_.push_back({first, structure_.elements()[first].node[0], structure_.elements()[first + 1].node[1],
                                node, Mat6::Zero()});
    lay_out();
}

/// The first element of the pair whose middle node this is, -1 if it is none.
template <class Number>
int Condensed<Number>::pair_about(int node) const {
    const auto at = structure_.elements_at(node);
    return at.size() == 2 && structure_.elements()[at[0]].partner == at[1] ? std::min(at[0], at[1]) : -1;
}

template <class Number>
void Condensed<Number>::renew_between(CondensedNode& m, const ElementMatrices& parts) const {
    const Mat6 inverse = inverse_by_halves(parts.own(m.node));
    put(m.inverse, inverse);
    for (int s = 0; s < m.count; ++s)
        if (parts.empty(m.element[s])) put(m.coupling[s], Mat6::Zero());
        else
            put(m.coupling[s],
                inverse * parts.across(m.element[s], end_at(structure_.elements()[m.element[s]], m.node)));
}

template <class Number>
void Condensed<Number>::renew_row(int place, const ElementMatrices& parts) {
    const int node = order_[place], begin = row_begin_[place];
    Mat6 own = parts.own(node);
    for (int k = 1; k < row_begin_[place + 1] - begin; ++k) {
        const int element = structure_.elements_at(node)[k - 1];
        const Element& e = structure_.elements()[element];
        const int next = other_node(e, node);
        if (parts.empty(element)) {
            put(&value_[36 * std::size_t(begin + k)], Mat6::Zero());
            continue;
        }
        Mat6 block = parts.across(element, end_at(e, node));
        if (place_[next] < 0) {
            const CondensedNode& m = between_[which_[next]];
            const int here = m.side[0] == node ? 0 : 1;
            own -= block * get(m.coupling[here]);
            if (m.count == 2) block = -block * get(m.coupling[1 - here]);
            else block.setZero();
            if (parts.has_bridges() && m.count == 2 && e.partner == m.element[1 - here])
                block += parts.bridge(std::min(element, e.partner), element < e.partner ? 0 : 1);
        }
        put(&value_[36 * std::size_t(begin + k)], block);
    }
    put(&value_[36 * std::size_t(begin)], own);
}

template <class Number>
void Condensed<Number>::renew_inverse(int place) {
    Mat6 own = get(&value_[36 * std::size_t(row_begin_[place])]);
    if (coupled_rows_.has(place)) own += coupled_rows_.own(place);
    put(&inverse_[36 * std::size_t(place)], inverse_by_halves(own));
}

template <class Number>
void Condensed<Number>::renew(const std::vector<int>& nodes, const ElementMatrices& parts) {
    std::vector<int> rows, taken_out;
    for (int i : nodes) {
        if (place_[i] >= 0) rows.push_back(place_[i]);
        if (which_[i] < 0) continue;
        const CondensedNode& m = between_[which_[i]];
        if (!m.excluded) taken_out.push_back(which_[i]);
        for (int s = 0; s < m.count; ++s) rows.push_back(place_[m.side[s]]);
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    pool_.share(int(taken_out.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) renew_between(between_[taken_out[i]], parts);
    });
    pool_.share(int(rows.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) renew_row(rows[i], parts), renew_inverse(rows[i]);
    });
    bool any = false;
    for (Bridge& b : bridges_) {
        if (!std::binary_search(nodes.begin(), nodes.end(), b.middle)) continue;
        const Mat6 K = parts.bridge(b.first, 0);
        any |= K != b.K;
        b.K = K;
    }
    if (any) take_couplings();  // summed anew: a run that goes on from its checkpoint has the same bits
}

/// Adds a row's product with x, from that entry of it on.
template <class Number>
inline void Condensed<Number>::add_row(Row& row, int place, int from, const double* x) const {
    for (int k = row_begin_[place] + from; k < row_begin_[place + 1]; ++k)
        row.add(&value_[36 * std::size_t(k)], &x[stride * column_[k]]);
    coupled_rows_.add_product(row, place, from, x);
}

/// r: the right side without the nodes between.
template <class Number>
void Condensed<Number>::reduce(const double* right) {
    pool_.share(int(staying_.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const int p = staying_[i];
            Wide sum = load_six(right + 6 * order_[p]);
            for (int k = row_begin_[p] + 1; k < row_begin_[p + 1]; ++k)
                if (const int side = condensed_side_[k]; side >= 0)
                    sum -= times_transposed(between_[side / 2].coupling[side % 2],
                                            load_six(right + 6 * between_[side / 2].node));
            store(&r_[stride * p], sum);
        }
    });
}

template <class Number>
void Condensed<Number>::solve_back(const double* right, double* x) const {
    pool_.share(int(staying_.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            std::memcpy(x + 6 * order_[staying_[i]], &x_[stride * staying_[i]], 6 * sizeof(double));
    });
    pool_.share(int(going_.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const CondensedNode& m = between_[going_[i]];
            Wide v = times(m.inverse, right + 6 * m.node);
            for (int s = 0; s < m.count; ++s) v -= times(m.coupling[s], &x_[stride * place_[m.side[s]]]);
            store_six(x + 6 * m.node, v);
        }
    });
}

/// On the red nodes: x takes its part of the last d, and the new d is what keeps their rows zero.
template <class Number>
void Condensed<Number>::follow(double alpha) {
    pool_.share(int(red_.size()), piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i) {
            const int p = red_[i];
            store(&x_[stride * p], load(&x_[stride * p]) + alpha * load(&d_[stride * p]));
            Row row;
            add_row(row, p, 1, d_.data());
            double sum[8];
            store(sum, row.sum());
            store(&d_[stride * p], -times(&inverse_[36 * std::size_t(p)], sum));
        }
    });
}

/// q = S d on the black nodes; returns d . q.
template <class Number>
double Condensed<Number>::multiply() {
    return pool_.sum(int(black_.size()), piece, [&](int first, int end) {
        Wide product{};
        for (int i = first; i < end; ++i) {
            const int p = black_[i];
            Row row;
            add_row(row, p, 0, d_.data());
            store(&q_[stride * p], row.sum());
            product += six * row.sum() * load(&d_[stride * p]);
        }
        return sum(product);
    });
}

/// x satisfies the red rows from the start, r is what the black rows lack, d = q; returns r . q.
template <class Number>
double Condensed<Number>::begin_iterations() {
    std::fill(x_.begin(), x_.end(), 0.0);
    std::fill(d_.begin(), d_.end(), 0.0);
    for (int p : red_) store(&x_[stride * p], times(&inverse_[36 * std::size_t(p)], &r_[stride * p]));
    return pool_.sum(int(black_.size()), piece, [&](int first, int end) {
        Wide product{};
        for (int i = first; i < end; ++i) {
            const int p = black_[i];
            Row row;
            add_row(row, p, 1, x_.data());
            store(&r_[stride * p], load(&r_[stride * p]) - row.sum());
            product += precondition(&inverse_[36 * std::size_t(p)], &r_[stride * p], &q_[stride * p]);
            store(&d_[stride * p], load(&q_[stride * p]));
        }
        return sum(product);
    });
}

/// x += alpha d, r -= alpha q and q = D^-1 r on the black nodes; returns r . q.
template <class Number>
double Condensed<Number>::step_along(double alpha) {
    return pool_.sum(int(black_.size()), piece, [&](int first, int end) {
        Wide product{};
        for (int i = first; i < end; ++i) {
            const int p = black_[i];
            store(&r_[stride * p], load(&r_[stride * p]) - alpha * load(&q_[stride * p]));
            store(&x_[stride * p], load(&x_[stride * p]) + alpha * load(&d_[stride * p]));
            product += precondition(&inverse_[36 * std::size_t(p)], &r_[stride * p], &q_[stride * p]);
        }
        return sum(product);
    });
}

/// d = q + beta d on the black nodes.
template <class Number>
void Condensed<Number>::turn_direction(double beta) {
    pool_.share(int(black_.size()), 4 * piece, [&](int first, int end, int) {
        for (int i = first; i < end; ++i)
            store(&d_[stride * black_[i]], load(&q_[stride * black_[i]]) + beta * load(&d_[stride * black_[i]]));
    });
}

template <class Number>
SolveReport Condensed<Number>::solve(const double* right, double* solution, const SolverSettings& settings) {
    reduce(right);
    double rho = begin_iterations();
    const double goal = std::max(rho * settings.tolerance * settings.tolerance, settings.floor);
    SolveReport report;
    if (rho < -std::max(settings.floor, 1e-280)) {  // a node's own block is not positive definite
        keep_worst_block();
        return {0, false, true};
    }
    double before = 0;  // alpha of the last step
    while (rho > goal && rho > 1e-280) {
        if (report.iterations == settings.max_iterations) return report.converged = false, report;
        follow(before);
        const double dq = multiply();
        if (!(dq > 0)) return {report.iterations, false, dq <= 0};
        const double alpha = rho / dq;
        const double next = step_along(alpha);
        const double beta = next / rho;
        rho = next;
        before = alpha;
        turn_direction(beta);
        ++report.iterations;
    }
    for (int p : red_) store(&x_[stride * p], load(&x_[stride * p]) + before * load(&d_[stride * p]));
    solve_back(right, solution);
    report.converged = std::isfinite(rho);
    return report;
}

/// d: the preconditioned r at the black node where it is most opposed to r, zero elsewhere.
template <class Number>
void Condensed<Number>::keep_worst_block() {
    const auto product = [&](int p) { return sum(Wide(six * load(&q_[stride * p]) * load(&r_[stride * p]))); };
    int worst = black_.front();
    for (int p : black_)
        if (product(p) < product(worst)) worst = p;
    std::fill(d_.begin(), d_.end(), 0.0);
    store(&d_[stride * worst], load(&q_[stride * worst]));
}

template <class Number>
void Condensed<Number>::direction(double* d) const {
    std::fill(d, d + 6 * which_.size(), 0.0);
    for (int p : staying_) std::memcpy(d + 6 * order_[p], &d_[stride * p], 6 * sizeof(double));
    for (int i : going_) {
        const CondensedNode& m = between_[i];
        Wide v{};
        for (int s = 0; s < m.count; ++s) v -= times(m.coupling[s], &d_[stride * place_[m.side[s]]]);
        store_six(d + 6 * m.node, v);
    }
}

template class Condensed<float>;
template class Condensed<double>;

}  // namespace hinge
