// Rows of a CSV or TSV file, one after another, as numbers and as text.
//
// The common row, five plain decimals between separators, takes a fast way; everything else (quotes, blanks
// around numbers, empty fields, nan, comments, damage) is looked at a second time by a careful one.
// An empty field is NaN. A row with too few fields or with zero bytes in it is damage: reported as such, with
// its place. A last row that has no line end and can't be read was cut.
//
// Errors: those of FileWindow::open and makeCsvLayout, UnknownFormat (a line beyond all measure), NotANumber
// (text in a number column; names line and column).
#pragma once

#include "engine/formats/csv_header.h"
#include "engine/formats/file_window.h"
#include "engine/recording/recording.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace driftbench {

enum class CsvRowKind
{
    Sample,
    Other,  // blank, a comment, the header once more
    Damaged // nothing to be read from it
};

struct CsvRow
{
    CsvRowKind kind = CsvRowKind::Other;
    std::array<double, kCsvQuantityCount> values{}; // of a sample: s, degrees Celsius, dps
    std::string_view text;                          // with its line end, if it has one
};

class CsvScanner
{
public:
    static Result<CsvScanner> open(const std::filesystem::path &path, const CsvOptions &options);

    // The text before the first row: comments and header, each with its line end.
    const std::string &preamble() const { return m_preamble; }
    const CsvLayout &layout() const { return m_layout; }
    const SensorIdentity &sensor() const { return m_sensor; } // as comments state it
    bool simulated() const { return m_simulated; }

    // The next row; false at the end and on an error. A row's text is valid until the next call.
    bool next(CsvRow &row);
    const Status &status() const { return m_status; }
    std::vector<std::string> warnings() const; // of what was read so far

    double fractionRead() const; // of the file, 0..1

private:
    explicit CsvScanner(FileWindow window, std::string file);

    Status readPreamble(const CsvOptions &options);
    void readComment(std::string_view line);
    Result<CsvLayout> layoutFrom(std::string_view firstRow, std::string_view lastComment,
                                 const CsvOptions &options);
    void prepareFastWay();

    bool fillLine(); // makes m_at .. m_linesEnd hold a whole line
    const char *scanFast(const char *at, std::array<double, kCsvQuantityCount> &values) const;
    void readCarefully(std::string_view line, CsvRow &row);
    bool readFields(std::string_view line, CsvRow &row);
    void noteDamage(CsvRow &row);
    void noteCut(CsvRow &row);
    std::uint64_t offsetOfLine() const;

    FileWindow m_window;
    std::string m_file; // for messages
    std::string m_preamble;
    CsvLayout m_layout;
    SensorIdentity m_sensor;
    bool m_simulated = false;
    Status m_status;

    std::vector<int> m_slots; // per field up to the last that is needed: its quantity, or -1
    bool m_scaled = false;
    bool m_sharedColumn = false; // one field for several quantities: the careful way only

    const char *m_at = nullptr;       // where the next row begins
    const char *m_linesEnd = nullptr; // behind the last whole line in the window
    std::vector<char> m_lastLine;     // the file's last line if it has no end, with one
    bool m_inLastLine = false;
    std::uint64_t m_line = 0; // number of the last row that was read, from 1

    std::uint64_t m_damagedRows = 0;
    std::uint64_t m_firstDamageLine = 0;
    std::uint64_t m_firstDamageOffset = 0;
    std::uint64_t m_repeatedHeaders = 0;
    bool m_cut = false;
    std::uint64_t m_cutOffset = 0;
};

} // namespace driftbench
