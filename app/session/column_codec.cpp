#include "app/session/column_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <optional>
#include <vector>

namespace driftbench {

namespace {

static_assert(std::endian::native == std::endian::little, "columns are written as they are in memory");

enum class Form : std::uint8_t
{
    Raw = 0,
    Float32 = 1,
    Grid = 2,
    Scaled = 3,
    Line = 4
};

struct Header
{
    Form form = Form::Raw;
    std::uint8_t width = 8; // bytes a value
    std::uint16_t zero = 0;
    std::uint32_t count = 0;
};
static_assert(sizeof(Header) == 8);

constexpr double kLargestWhole = 9007199254740992.0; // 2^53: up to here doubles hold every whole number
constexpr int kMostDecimals = 9;

struct Grid
{
    std::int64_t offset = 0;
    std::int64_t step = 1;
    double divisor = 1.0;

    double value(std::uint32_t n) const
    {
        return (static_cast<double>(offset) + static_cast<double>(n) * static_cast<double>(step)) / divisor;
    }
};

struct Scaled
{
    std::int64_t offset = 0;
    double scale = 1.0;

    double value(std::uint32_t n) const
    {
        return (static_cast<double>(offset) + static_cast<double>(n)) * scale;
    }
};

struct Line
{
    std::int64_t offset = 0;
    double first = 0.0;
    double step = 0.0;

    std::uint64_t bits(std::size_t i) const
    {
        return std::bit_cast<std::uint64_t>(first + static_cast<double>(i) * step);
    }
};

template <class T>
void put(std::string &bytes, const T &value)
{
    bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::uint8_t widthFor(std::uint64_t largest)
{
    return largest <= 0xffU ? 1 : largest <= 0xffffU ? 2 : 4;
}

template <class Parameters>
struct Fitted
{
    Parameters parameters;
    std::vector<std::uint32_t> numbers;
    std::uint8_t width = 4;
};

// The numbers of whole[i] = offset + n[i] step, unless they need more than 4 bytes.
template <class Parameters>
std::optional<Fitted<Parameters>> numbered(const std::vector<std::int64_t> &whole, std::int64_t lowest,
                                           std::uint64_t range, std::uint64_t step)
{
    if (range / step > 0xffffffffU)
        return std::nullopt;
    Fitted<Parameters> fitted{{}, std::vector<std::uint32_t>(whole.size()), widthFor(range / step)};
    fitted.parameters.offset = lowest;
    for (std::size_t i = 0; i < whole.size(); ++i)
        fitted.numbers[i] = static_cast<std::uint32_t>(
            (static_cast<std::uint64_t>(whole[i]) - static_cast<std::uint64_t>(lowest)) / step);
    return fitted;
}

bool wholeMultiples(std::span<const double> values, double divisor, std::vector<std::int64_t> &whole)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double multiple = std::nearbyint(values[i] * divisor);
        if (!(std::abs(multiple) < kLargestWhole) || !sameBits(multiple / divisor, values[i]) ||
            (multiple == 0.0 && std::signbit(values[i])))
            return false;
        whole[i] = static_cast<std::int64_t>(multiple);
    }
    return true;
}

std::optional<Fitted<Grid>> fitGrid(std::span<const double> values)
{
    std::vector<std::int64_t> whole(values.size());
    double divisor = 1.0;
    for (int decimals = 0; decimals <= kMostDecimals; ++decimals, divisor *= 10.0) {
        if (!wholeMultiples(values, divisor, whole))
            continue;
        const auto [lowest, highest] = std::minmax_element(whole.begin(), whole.end());
        std::int64_t step = 0;
        for (const std::int64_t value : whole)
            step = step == 1 ? 1 : std::gcd(step, value - *lowest);
        step = std::max<std::int64_t>(step, 1);
        auto fitted = numbered<Grid>(whole, *lowest, static_cast<std::uint64_t>(*highest - *lowest),
                                     static_cast<std::uint64_t>(step));
        if (fitted) {
            fitted->parameters.step = step;
            fitted->parameters.divisor = divisor;
        }
        return fitted;
    }
    return std::nullopt;
}

bool multiplesOf(double scale, std::span<const double> values, std::vector<std::int64_t> &whole)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double multiple = std::nearbyint(values[i] / scale);
        if (!(std::abs(multiple) < 2147483648.0) || !sameBits(multiple * scale, values[i]) ||
            (multiple == 0.0 && std::signbit(values[i])))
            return false;
        whole[i] = static_cast<std::int64_t>(multiple);
    }
    return true;
}

// What the values may be whole multiples of: the smallest difference between two of the first, made exact by
// the largest value; and the decimal next to it, which is what data sheets print.
std::vector<double> likelyScales(std::span<const double> values)
{
    const std::size_t looked = std::min<std::size_t>(values.size(), 1024);
    std::vector<double> sorted(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(looked));
    if (!std::all_of(sorted.begin(), sorted.end(), [](double v) { return std::isfinite(v); }))
        return {};
    std::sort(sorted.begin(), sorted.end());
    const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double difference = sorted[i] - sorted[i - 1];
        // Neighbouring multiples differ by far more than the rounding of either.
        if (difference > largest * 1e-12)
            smallest = std::min(smallest, difference);
    }
    const double multiple = std::nearbyint(largest / smallest);
    if (!std::isfinite(smallest) || multiple < 1.0 || multiple > 2147483647.0)
        return {};
    const double scale = largest / multiple;
    std::vector<double> scales{std::nearbyint(scale * 1e9) / 1e9, scale};
    double below = scale;
    double above = scale;
    for (int ulp = 0; ulp < 2; ++ulp) {
        below = std::nextafter(below, 0.0);
        above = std::nextafter(above, 2.0 * scale);
        scales.insert(scales.end(), {below, above});
    }
    return scales;
}

std::optional<Fitted<Scaled>> fitScaled(std::span<const double> values)
{
    std::vector<std::int64_t> whole(values.size());
    for (const double scale : likelyScales(values)) {
        if (!(scale > 0.0) || !multiplesOf(scale, values, whole))
            continue;
        const auto [lowest, highest] = std::minmax_element(whole.begin(), whole.end());
        auto fitted = numbered<Scaled>(whole, *lowest, static_cast<std::uint64_t>(*highest - *lowest), 1);
        if (fitted)
            fitted->parameters.scale = scale;
        return fitted;
    }
    return std::nullopt;
}

std::optional<Fitted<Line>> fitLine(std::span<const double> values)
{
    const std::size_t size = values.size();
    Line line{0, values.front(),
              size < 2 ? 0.0 : (values.back() - values.front()) / static_cast<double>(size - 1)};
    if (!std::isfinite(line.first) || !std::isfinite(line.step))
        return std::nullopt;
    std::vector<std::int64_t> residual(size);
    for (std::size_t i = 0; i < size; ++i)
        residual[i] = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(values[i]) - line.bits(i));
    const auto [lowest, highest] = std::minmax_element(residual.begin(), residual.end());
    auto fitted = numbered<Line>(
        residual, *lowest, static_cast<std::uint64_t>(*highest) - static_cast<std::uint64_t>(*lowest), 1);
    if (fitted) {
        line.offset = *lowest;
        fitted->parameters = line;
    }
    return fitted;
}

template <class Number>
void putNumbers(std::string &bytes, const std::vector<std::uint32_t> &numbers)
{
    const std::size_t start = bytes.size();
    bytes.resize(start + numbers.size() * sizeof(Number));
    char *out = bytes.data() + start;
    for (const std::uint32_t number : numbers) {
        const auto narrow = static_cast<Number>(number);
        std::memcpy(out, &narrow, sizeof narrow);
        out += sizeof narrow;
    }
}

template <class Parameters>
std::string written(Form form, const Fitted<Parameters> &fitted)
{
    std::string bytes;
    bytes.reserve(sizeof(Header) + sizeof(Parameters) + fitted.numbers.size() * fitted.width);
    put(bytes, Header{form, fitted.width, 0, static_cast<std::uint32_t>(fitted.numbers.size())});
    put(bytes, fitted.parameters);
    if (fitted.width == 1)
        putNumbers<std::uint8_t>(bytes, fitted.numbers);
    else if (fitted.width == 2)
        putNumbers<std::uint16_t>(bytes, fitted.numbers);
    else
        putNumbers<std::uint32_t>(bytes, fitted.numbers);
    return bytes;
}

bool isFloat32(std::span<const double> values)
{
    return std::all_of(values.begin(), values.end(), [](double value) {
        return sameBits(static_cast<double>(static_cast<float>(value)), value);
    });
}

std::string writtenFloat32(std::span<const double> values)
{
    std::string bytes;
    bytes.reserve(sizeof(Header) + values.size() * sizeof(float));
    put(bytes, Header{Form::Float32, 4, 0, static_cast<std::uint32_t>(values.size())});
    for (const double value : values)
        put(bytes, static_cast<float>(value));
    return bytes;
}

std::string writtenRaw(std::span<const double> values)
{
    std::string bytes;
    bytes.reserve(sizeof(Header) + values.size() * sizeof(double));
    put(bytes, Header{Form::Raw, 8, 0, static_cast<std::uint32_t>(values.size())});
    bytes.append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(double));
    return bytes;
}

template <class Number, class Value>
void readEach(const char *numbers, std::span<double> values, Value value)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        Number number;
        std::memcpy(&number, numbers + i * sizeof number, sizeof number);
        values[i] = value(number, i);
    }
}

template <class Value>
bool readNumbers(std::uint8_t width, const char *numbers, std::span<double> values, Value value)
{
    if (width == 1)
        readEach<std::uint8_t>(numbers, values, value);
    else if (width == 2)
        readEach<std::uint16_t>(numbers, values, value);
    else if (width == 4)
        readEach<std::uint32_t>(numbers, values, value);
    else
        return false;
    return true;
}

template <class Parameters>
std::optional<Parameters> parametersOf(std::string_view body, const Header &header)
{
    if (body.size() != sizeof(Parameters) + std::size_t{header.width} * header.count)
        return std::nullopt;
    Parameters parameters;
    std::memcpy(&parameters, body.data(), sizeof parameters);
    return parameters;
}

} // namespace

std::string encodeColumn(std::span<const double> values)
{
    if (values.empty())
        return writtenRaw(values);
    if (const auto grid = fitGrid(values))
        return written(Form::Grid, *grid);
    if (const auto scaled = fitScaled(values))
        return written(Form::Scaled, *scaled);
    const auto line = fitLine(values);
    if (line && line->width < 4)
        return written(Form::Line, *line);
    if (isFloat32(values))
        return writtenFloat32(values);
    return line ? written(Form::Line, *line) : writtenRaw(values);
}

bool decodeColumn(std::string_view bytes, std::span<double> values)
{
    Header header;
    if (bytes.size() < sizeof header)
        return false;
    std::memcpy(&header, bytes.data(), sizeof header);
    const std::string_view body = bytes.substr(sizeof header);
    if (header.count != values.size())
        return false;
    switch (header.form) {
    case Form::Raw:
        if (body.size() != values.size() * sizeof(double))
            return false;
        std::copy_n(body.data(), body.size(), reinterpret_cast<char *>(values.data()));
        return true;
    case Form::Float32:
        if (body.size() != values.size() * sizeof(float))
            return false;
        readEach<float>(body.data(), values,
                        [](float value, std::size_t) { return static_cast<double>(value); });
        return true;
    case Form::Grid:
        if (const auto grid = parametersOf<Grid>(body, header))
            return readNumbers(header.width, body.data() + sizeof(Grid), values,
                               [grid = *grid](std::uint32_t n, std::size_t) { return grid.value(n); });
        return false;
    case Form::Scaled:
        if (const auto scaled = parametersOf<Scaled>(body, header))
            return readNumbers(header.width, body.data() + sizeof(Scaled), values,
                               [scaled = *scaled](std::uint32_t n, std::size_t) { return scaled.value(n); });
        return false;
    case Form::Line:
        if (const auto line = parametersOf<Line>(body, header))
            return readNumbers(header.width, body.data() + sizeof(Line), values,
                               [line = *line](std::uint32_t n, std::size_t i) {
                                   return std::bit_cast<double>(line.bits(i) +
                                                                static_cast<std::uint64_t>(line.offset) + n);
                               });
        return false;
    }
    return false;
}

} // namespace driftbench
