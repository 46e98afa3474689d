#include "sim/condensed.h"

#include <algorithm>

#include "sim/blocks.h"

namespace hinge {

using namespace blocks;

namespace {

Eigen::Map<const Mat6> block(const double* value, int place) { return Eigen::Map<const Mat6>(value + 36 * std::size_t(place)); }

}  // namespace

Condensed::Condensed(const std::vector<int>& row, const std::vector<int>& column) : row_(row), column_(column) {
    const int n = int(row.size()) - 1;
    which_.assign(n, -1);
    for (int i = n - 1; i >= 0; --i) {  // inner nodes come after the joints
        const int count = row[i + 1] - row[i] - 1;
        const bool alone = std::all_of(column.begin() + row[i] + 1, column.begin() + row[i + 1], [&](int j) { return which_[j] < 0; });
        if (count > 2 || !alone) continue;
        Between m{i, count, {}, {}, false, {}, {}};
        for (int s = 0; s < count; ++s) {
            m.side[s] = column[row[i] + 1 + s];
            m.to[s] = row[i] + 1 + s;
        }
        which_[i] = int(between_.size());
        between_.push_back(m);
    }
    rows_.resize(n);
    int slots = 0;
    for (int i = 0; i < n; ++i) {
        std::vector<int> columns(column.begin() + row[i] + 1, column.begin() + row[i + 1]);
        for (int j : std::vector<int>(columns))
            if (which_[j] >= 0)
                for (int s = 0; s < between_[which_[j]].count; ++s)
                    if (const int other = between_[which_[j]].side[s]; other != i) columns.push_back(other);
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
        rows_[i].push_back({i, -1});
        for (int j : columns) rows_[i].push_back({j, -1});
    }
    // what is used while nothing is kept lies together
    for (bool usual : {true, false})
        for (int i = 0; i < n; ++i)
            for (Entry& e : rows_[i])
                if ((which_[i] < 0 && which_[e.column] < 0) == usual) e.slot = slots++;
    value_.assign(36 * std::size_t(slots) + 2, 0);
    y_.assign(stride * between_.size(), 0);
    list();
}

int Condensed::entry(int node, int column) const {
    const std::vector<Entry>& row = rows_[node];
    if (column == node) return row[0].slot;
    return std::lower_bound(row.begin() + 1, row.end(), column, [](const Entry& e, int c) { return e.column < c; })->slot;
}

void Condensed::list() {
    ++arrangement_;
    const auto stays = [&](int i) { return which_[i] < 0 || between_[which_[i]].kept; };
    order_.clear();
    begin_.assign(1, 0);
    slot_.clear();
    at_.clear();
    place_.assign(rows_.size(), -1);
    for (int i = 0; i < int(rows_.size()); ++i)
        if (stays(i)) place_[i] = int(order_.size()), order_.push_back(i);
    for (int i : order_) {
        for (const Entry& e : rows_[i])
            if (place_[e.column] >= 0) slot_.push_back(e.slot), at_.push_back(place_[e.column]);
        begin_.push_back(int(slot_.size()));
    }
}

void Condensed::keep(std::vector<int> nodes, std::vector<int>& changed) {
    std::erase_if(nodes, [&](int i) { return which_[i] < 0; });
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    if (nodes == kept_) return;
    for (const auto* list : {&kept_, &nodes})
        for (int i : *list) between_[which_[i]].kept = list == &nodes, changed.push_back(i);
    kept_ = std::move(nodes);
    list();
}

void Condensed::renew_between(Between& m, const double* value) const {
    const Mat6 inverse = inverse_by_halves(block(value, row_[m.node]));
    std::memcpy(m.inverse, inverse.data(), sizeof(double) * 36);
    for (int s = 0; s < m.count; ++s) {
        const Mat6 pull = inverse * block(value, m.to[s]);
        std::memcpy(m.pull[s], pull.data(), sizeof(double) * 36);
    }
}

void Condensed::renew_row(int node, const double* value) {
    for (const Entry& e : rows_[node]) std::fill_n(&value_[36 * std::size_t(e.slot)], 36, 0.0);
    const auto at = [&](int column) { return Eigen::Map<Mat6>(&value_[36 * std::size_t(entry(node, column))]); };
    at(node) += block(value, row_[node]);
    for (int k = row_[node] + 1; k < row_[node + 1]; ++k) {
        const int j = column_[k];
        if (place_[j] >= 0) {
            at(j) += block(value, k);
            continue;
        }
        const Between& m = between_[which_[j]];
        for (int s = 0; s < m.count; ++s) at(m.side[s]).noalias() -= block(value, k) * Eigen::Map<const Mat6>(m.pull[s]);
    }
}

const std::vector<int>& Condensed::renew(const std::vector<int>& nodes, const double* value) {
    std::vector<int>& rows = renewed_;
    rows.clear();
    for (int i : nodes) {
        if (place_[i] >= 0) rows.push_back(i);
        if (which_[i] < 0) continue;
        Between& m = between_[which_[i]];
        if (!m.kept) renew_between(m, value);
        for (int s = 0; s < m.count; ++s) rows.push_back(m.side[s]);
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::erase_if(rows, [&](int i) { return place_[i] < 0; });
    for (int i : rows) renew_row(i, value);
    return rows;
}

Mat6 Condensed::diagonal(int place) const { return block(value_.data(), slot_[begin_[place]]); }

void Condensed::reduce(const double* right, double* b) {
    for (std::size_t i = 0; i < order_.size(); ++i) store(b + stride * i, load(right + 6 * order_[i]));
    for (std::size_t i = 0; i < between_.size(); ++i) {
        const Between& m = between_[i];
        if (m.kept) continue;
        const double* r = right + 6 * m.node;
        store(&y_[stride * i], times(m.inverse, r));
        const Wide masked = six * load(r);
        for (int s = 0; s < m.count; ++s) {  // A_side,m A_mm^-1 r
            double* to = b + stride * place_[m.side[s]];
            store(to, load(to) - times_transposed(m.pull[s], masked));
        }
    }
}

double Condensed::multiply(const double* x, double* y) const {
    Wide product{};
    for (int i = 0; i < size(); ++i) {
        Wide row{};
        for (int k = begin_[i]; k < begin_[i + 1]; ++k) row += times(&value_[36 * std::size_t(slot_[k])], x + stride * at_[k]);
        store(y + stride * i, row);
        product += six * row * load(x + stride * i);
    }
    return sum(product);
}

void Condensed::solve_back(const double* x, double* solution) const {
    for (std::size_t i = 0; i < order_.size(); ++i) std::memcpy(solution + 6 * order_[i], x + stride * i, 6 * sizeof(double));
    for (std::size_t i = 0; i < between_.size(); ++i) {
        const Between& m = between_[i];
        if (m.kept) continue;
        Wide v = load(&y_[stride * i]);
        for (int s = 0; s < m.count; ++s) v -= times(m.pull[s], x + stride * place_[m.side[s]]);
        store_six(solution + 6 * m.node, v);
    }
}

}  // namespace hinge
