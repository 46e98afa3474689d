// Serialisation: writes values as bytes and reads them back. One list of fields serves both, so they always agree.
//
// A type lists its fields once,
//   template <class Self, class Archive> static void fields(Self& self, Archive& a) { a(self.x, self.list); }
// where Self is const when writing. The byte order is little endian. Reading checks all bytes: incomplete or invalid
// ones throw Damaged, and no input makes it allocate more than a few times its own size.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/types.h"

namespace hinge {

static_assert(std::endian::native == std::endian::little, "checkpoints are written as the numbers lie in memory");

/// Raised where bytes are incomplete or hold no valid values.
struct Damaged : std::runtime_error {
    using std::runtime_error::runtime_error;
};

namespace archive {

/// True for types that are copied byte by byte: their memory holds the value without gaps.
template <class T>
constexpr bool is_plain = (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_enum_v<T> ||
                          std::is_same_v<T, Quat> || std::is_base_of_v<Eigen::EigenBase<T>, T>;

/// Writes or reads one value of any type.
template <class A, class T>
void value(A& a, T& v);

/// Writes or reads a list: its length, then its entries.
template <class A, class List>
void list(A& a, List& v) {
    using T = typename std::remove_const_t<List>::value_type;
    std::uint64_t n = v.size();
    value(a, n);
    if constexpr (is_plain<T>) {
        if constexpr (A::reading) a.must_hold(n, sizeof(T)), v.resize(n);
        a.bytes(v.data(), n * sizeof(T));
    } else if constexpr (A::reading) {
        a.must_hold(n, 1);
        v.clear();
        for (std::uint64_t i = 0; i < n; ++i) value(a, v.emplace_back());
    } else {
        for (auto& each : v) value(a, each);
    }
}

/// Writes or reads a map in the order of its keys, so that equal contents give equal bytes.
template <class A, class Map>
void map(A& a, Map& m) {
    std::uint64_t n = m.size();
    value(a, n);
    if constexpr (A::reading) {
        a.must_hold(n, 1);
        m.clear();
        for (std::uint64_t i = 0; i < n; ++i) {
            typename Map::key_type key{};
            value(a, key);
            value(a, m[key]);
        }
    } else {
        std::vector<const typename Map::value_type*> entries;
        for (const auto& entry : m) entries.push_back(&entry);
        std::sort(entries.begin(), entries.end(), [](auto* p, auto* q) { return p->first < q->first; });
        for (const auto* entry : entries) value(a, entry->first), value(a, entry->second);
    }
}

/// Kind of a standard container: list, map, optional or pair.
template <class T>
struct ContainerTraits {
    static constexpr bool list = false, map = false, optional = false, pair = false;
};
template <class T, class A>
struct ContainerTraits<std::vector<T, A>> : ContainerTraits<void> {
    static constexpr bool list = true;
};
template <>
struct ContainerTraits<std::string> : ContainerTraits<void> {
    static constexpr bool list = true;
};
template <class K, class T>
struct ContainerTraits<std::map<K, T>> : ContainerTraits<void> {
    static constexpr bool map = true;
};
template <class K, class T>
struct ContainerTraits<std::unordered_map<K, T>> : ContainerTraits<void> {
    static constexpr bool map = true;
};
template <class T>
struct ContainerTraits<std::optional<T>> : ContainerTraits<void> {
    static constexpr bool optional = true;
};
template <class T, class U>
struct ContainerTraits<std::pair<T, U>> : ContainerTraits<void> {
    static constexpr bool pair = true;
};

template <class A, class T>
void value(A& a, T& v) {
    using Plain = std::remove_const_t<T>;
    if constexpr (is_plain<Plain>) {
        a.bytes(&v, sizeof v);
    } else if constexpr (std::is_same_v<Plain, bool>) {
        std::uint8_t byte = v;
        a.bytes(&byte, 1);
        if constexpr (A::reading) a.must(byte <= 1), v = byte != 0;
    } else if constexpr (std::is_array_v<T>) {
        for (auto& each : v) value(a, each);
    } else if constexpr (ContainerTraits<Plain>::list) {
        list(a, v);
    } else if constexpr (ContainerTraits<Plain>::map) {
        map(a, v);
    } else if constexpr (ContainerTraits<Plain>::pair) {
        value(a, v.first), value(a, v.second);
    } else if constexpr (ContainerTraits<Plain>::optional) {
        bool there = v.has_value();
        value(a, there);
        if constexpr (A::reading) v.reset();
        if constexpr (A::reading)
            if (there) v.emplace();
        if (there) value(a, *v);
    } else {
        Plain::fields(v, a);
    }
}

}  // namespace archive

/// Writes values: appends their bytes to a string.
class Writer {
public:
    static constexpr bool reading = false;
    explicit Writer(std::string& out) : out_(out) {}
    template <class... T>
    void operator()(const T&... values) {
        (archive::value(*this, values), ...);
    }
    void bytes(const void* from, std::size_t n) { out_.append(static_cast<const char*>(from), n); }

private:
    std::string& out_;
};

/// Reads values from bytes that it does not own.
class Reader {
public:
    static constexpr bool reading = true;
    explicit Reader(std::string_view in) : in_(in) {}
    template <class... T>
    void operator()(T&... values) {
        (archive::value(*this, values), ...);
    }
    void bytes(void* to, std::size_t n) {
        must_hold(n, 1);
        if (n > 0) std::memcpy(to, in_.data(), n);
        in_.remove_prefix(n);
    }
    /// Throws Damaged unless the rest can hold n entries of at least `each` bytes.
    void must_hold(std::uint64_t n, std::size_t each) const { must(n <= in_.size() / each); }
    void must(bool good) const {
        if (!good) throw Damaged("its contents are not valid");
    }
    std::string_view rest() const { return in_; }  ///< not yet read

private:
    std::string_view in_;
};

}  // namespace hinge
