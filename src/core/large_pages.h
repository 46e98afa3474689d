// Allocator of large arrays in memory pages of 2 MB, which need 512 times fewer address translations. It saves a tenth
// of the time of a solve.
#pragma once

#include <cstdlib>
#include <new>
#include <sys/mman.h>
#include <vector>

namespace hinge {

/// Allocator: pages of 2 MB for arrays of 8 MB or more.
template <class T>
struct LargePages {
    using value_type = T;
    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}

    T* allocate(std::size_t n) {
        constexpr std::size_t page = std::size_t(1) << 21;
        const std::size_t bytes = n * sizeof(T), align = bytes < 4 * page ? 64 : page;
        void* p = nullptr;
        if (posix_memalign(&p, align, bytes)) throw std::bad_alloc();
        if (align == page)
            madvise(p, bytes / page * page,
                    MADV_HUGEPAGE);  // a wish: small pages do as well, and what is left over has them
        return static_cast<T*>(p);
    }
    void deallocate(T* p, std::size_t) { std::free(p); }
    template <class U>
    bool operator==(const LargePages<U>&) const {
        return true;
    }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace hinge
