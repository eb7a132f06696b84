// A file seen through a window that slides forward: the readers' memory is bounded by the window, whatever
// the size of the file.
//
// Errors of open: FileNotFound, FileUnreadable (a folder, no permission), FileEmpty.
#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace driftbench {

class FileWindow
{
public:
    static constexpr std::size_t kDefaultBytes = std::size_t{1} << 18;

    static Result<FileWindow> open(const std::filesystem::path &path,
                                   std::size_t windowBytes = kDefaultBytes);

    FileWindow(FileWindow &&other) noexcept;
    FileWindow &operator=(FileWindow &&other) = delete;
    FileWindow(const FileWindow &) = delete;
    FileWindow &operator=(const FileWindow &) = delete;
    ~FileWindow();

    std::uint64_t fileBytes() const { return m_fileBytes; }
    std::uint64_t offset() const { return m_offset; } // of the window's first byte in the file
    std::string_view bytes() const { return {m_buffer.data() + m_begin, m_end - m_begin}; }

    // Lengthens the window to at least `count` bytes, reading as far ahead as the buffer allows; false where
    // the file (or what can be read of it) ends before. Views into bytes() become invalid.
    bool fill(std::size_t count);
    void consume(std::size_t count); // moves the window's begin on; count <= bytes().size()
    bool atEnd() const { return m_ended; }

    // Of the disk: FileUnreadable once a read has failed.
    const Status &status() const { return m_status; }

private:
    FileWindow(std::filesystem::path path, int descriptor, std::uint64_t fileBytes, std::size_t windowBytes);
    void makeRoom(std::size_t count);
    void readMore();

    std::filesystem::path m_path;
    int m_descriptor = -1;
    std::uint64_t m_fileBytes = 0;
    std::uint64_t m_offset = 0;
    std::vector<char> m_buffer;
    std::size_t m_begin = 0;
    std::size_t m_end = 0;
    bool m_ended = false;
    Status m_status;
};

} // namespace driftbench
