// A queue in pieces that never move: appending copies nothing that is there, and the oldest go a piece at a
// time.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <deque>
#include <memory>

namespace driftbench {

template <class T, std::size_t kPiece = 1024>
class ChunkRing
{
public:
    explicit ChunkRing(std::size_t capacity) : m_capacity(capacity) {}
    ChunkRing(ChunkRing &&) noexcept = default;
    ChunkRing &operator=(ChunkRing &&) noexcept = default;

    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    bool hasDropped() const { return m_dropped; } // something older was here

    const T &operator[](std::size_t index) const
    {
        assert(index < m_size);
        return (*m_pieces[index / kPiece])[index % kPiece];
    }
    const T &front() const { return (*this)[0]; }
    const T &back() const { return (*this)[m_size - 1]; }

    void push(const T &value)
    {
        if (m_size == m_pieces.size() * kPiece) {
            if (m_size >= m_capacity + kPiece)
                dropOldest();
            else
                m_pieces.push_back(std::make_unique<std::array<T, kPiece>>());
        }
        (*m_pieces[m_size / kPiece])[m_size % kPiece] = value;
        ++m_size;
    }

private:
    void dropOldest() // its piece becomes the newest
    {
        m_pieces.push_back(std::move(m_pieces.front()));
        m_pieces.pop_front();
        m_size -= kPiece;
        m_dropped = true;
    }

    std::size_t m_capacity;
    std::size_t m_size = 0;
    bool m_dropped = false;
    std::deque<std::unique_ptr<std::array<T, kPiece>>> m_pieces;
};

} // namespace driftbench
