// What a run was made of, part by part as a count and a checksum, to know a checkpoint of another model or other
// settings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run/dynamics.h"

namespace hinge {

struct FingerprintPart {
    std::string name;  ///< "nodes", "members", ...
    std::uint64_t count = 0;
    std::uint32_t sum = 0;  ///< CRC-32 of all its numbers
    template <class Self, class A>
    static void fields(Self& s, A& a) {
        a(s.name, s.count, s.sum);
    }
};

/// Everything declared and every setting that changes bits. Of functions, whether there is one: what it does cannot be
/// seen.
std::vector<FingerprintPart> fingerprint(const Dynamics& run);

/// "members (40 there, 38 here) and loads"; "" where they are the same.
std::string difference(const std::vector<FingerprintPart>& there, const std::vector<FingerprintPart>& here);

}  // namespace hinge
