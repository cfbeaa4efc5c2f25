#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace geargraph {

/// The buffer of a Scratch, a base class so that it is constructed before the resource that uses it.
template <std::size_t Bytes>
struct ScratchBuffer {
  alignas(std::max_align_t) std::array<std::byte, Bytes> bytes;
};

/// Scratch memory for one call: a buffer on the stack, and growing blocks on the heap if it is too small.
/// Everything is released at the end, nothing before. For std::pmr containers:
///
///     Scratch<> scratch;
///     std::pmr::vector<int> marks(size, 0, &scratch);
///
/// Cost: no allocation while the buffer suffices, so that small mechanisms allocate little but their results.
template <std::size_t Bytes = 4096>
class Scratch final : private ScratchBuffer<Bytes>, public std::pmr::monotonic_buffer_resource {
 public:
  Scratch() : std::pmr::monotonic_buffer_resource(this->bytes.data(), Bytes) {}
};

}  // namespace geargraph
