#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace geargraph::inline base {

/// The buffer of a Scratch, there before the resource that uses it.
template <std::size_t Bytes>
struct ScratchBuffer {
  alignas(std::max_align_t) std::array<std::byte, Bytes> bytes;
};

/// Memory for what lives during one call: a buffer on the stack, and growing blocks where it does not reach.
/// All of it is given back at the end, nothing before. For std::pmr containers:
///
///     Scratch<> scratch;
///     std::pmr::vector<int> marks(size, 0, &scratch);
///
/// Cost: next to nothing where the buffer reaches, so that small mechanisms allocate little but their
/// results.
template <std::size_t Bytes = 4096>
class Scratch final : private ScratchBuffer<Bytes>, public std::pmr::monotonic_buffer_resource {
 public:
  Scratch() : std::pmr::monotonic_buffer_resource(this->bytes.data(), Bytes) {}
};

}  // namespace geargraph::inline base
