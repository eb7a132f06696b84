#include "engine/exports/device_image.h"

#include "engine/base/checksum.h"
#include "engine/exports/device_image_layout.h"
#include "engine/exports/table_csv.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace driftbench {

namespace {

Error unusable(const std::string &what)
{
    return Error{Errc::InvalidOption, what};
}

bool fitsText(const std::string &text, std::size_t size)
{
    return !text.empty() && text.size() <= size &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c <= '~'; });
}

Status checkEncodable(const CompensationTable &table)
{
    const SensorIdentity &sensor = table.provenance.sensor;
    if (!fitsText(sensor.model, BRIDGE_MODEL_SIZE) || !fitsText(sensor.serial, BRIDGE_SERIAL_SIZE)) {
        return unusable("A device's table is for one sensor, and \"" + sensor.model + "\", \"" +
                        sensor.serial + "\" are no model of up to " + std::to_string(BRIDGE_MODEL_SIZE) +
                        " and serial number of up to " + std::to_string(BRIDGE_SERIAL_SIZE) +
                        " letters without spaces; name the sensor when recording.");
    }
    if (std::none_of(table.compensated.begin(), table.compensated.end(), [](bool axis) { return axis; }))
        return unusable("The table compensates no axis; there is nothing to write into a device.");
    if (!(table.tdeDps.cwiseAbs().maxCoeff() < BRIDGE_TABLE_VALUE_LIMIT))
        return unusable("The table holds a drift error of 2^30 dps or more; no gyro has that, fit it anew.");
    return {};
}

void putText(std::uint8_t *at, const std::string &text)
{
    std::copy(text.begin(), text.end(), at);
}

std::string getText(const std::uint8_t *at, std::size_t size)
{
    return {at, std::find(at, at + size, std::uint8_t{0})};
}

void putFloat(std::uint8_t *at, float value)
{
    bridge_put_u32(at, std::bit_cast<std::uint32_t>(value));
}

float getFloat(const std::uint8_t *at)
{
    return std::bit_cast<float>(bridge_get_u32(at));
}

std::uint8_t *knotAt(std::vector<std::uint8_t> &bytes, Eigen::Index knot, std::size_t axis)
{
    return bytes.data() + BRIDGE_TABLE_VALUES + static_cast<std::size_t>(knot) * BRIDGE_TABLE_KNOT_SIZE +
           4 * axis;
}

const std::uint8_t *knotAt(std::span<const std::uint8_t> bytes, Eigen::Index knot, std::size_t axis)
{
    return bytes.data() + BRIDGE_TABLE_VALUES + static_cast<std::size_t>(knot) * BRIDGE_TABLE_KNOT_SIZE +
           4 * axis;
}

void putHeader(std::vector<std::uint8_t> &bytes, const CompensationTable &table,
               DeviceThermometer thermometer)
{
    std::uint8_t *header = bytes.data();
    bridge_put_u32(header + BRIDGE_TABLE_MAGIC, BRIDGE_TABLE_MAGIC_VALUE);
    header[BRIDGE_TABLE_VERSION] = BRIDGE_TABLE_VERSION_VALUE;
    for (std::size_t axis = 0; axis < 3; ++axis)
        header[BRIDGE_TABLE_AXES] |= static_cast<std::uint8_t>(table.compensated[axis] ? 1U << axis : 0U);
    header[BRIDGE_TABLE_THERMOMETER] =
        thermometer == DeviceThermometer::External ? BRIDGE_THERMOMETER_EXTERNAL : BRIDGE_THERMOMETER_DIE;
    putText(header + BRIDGE_TABLE_MODEL, table.provenance.sensor.model);
    putText(header + BRIDGE_TABLE_SERIAL, table.provenance.sensor.serial);
    bridge_put_u32(header + BRIDGE_TABLE_FIRST, static_cast<std::uint32_t>(table.firstMilliC));
    bridge_put_u32(header + BRIDGE_TABLE_LAST, static_cast<std::uint32_t>(table.lastMilliC));
    bridge_put_u32(header + BRIDGE_TABLE_KNOTS, static_cast<std::uint32_t>(table.size()));
}

void putFixed(std::vector<std::uint8_t> &bytes, const CompensationTable &table)
{
    const FixedPointTable fixed = makeFixedPointTable(table);
    // Below 2^30 dps there is at least one unit to a dps.
    assert(fixed.fractionBits >= 0 && fixed.shift >= 0);
    bytes[BRIDGE_TABLE_KIND] = BRIDGE_TABLE_FIXED;
    bridge_put_u32(bytes.data() + BRIDGE_TABLE_RECIPROCAL, fixed.reciprocal);
    bytes[BRIDGE_TABLE_SHIFT] = static_cast<std::uint8_t>(fixed.shift);
    bytes[BRIDGE_TABLE_FRACTION] = static_cast<std::uint8_t>(fixed.fractionBits);
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t units = fixed.values[static_cast<std::size_t>(i)][axis];
            bridge_put_u32(knotAt(bytes, i, axis), static_cast<std::uint32_t>(units));
        }
    }
}

void putFloats(std::vector<std::uint8_t> &bytes, const CompensationTable &table)
{
    bytes[BRIDGE_TABLE_KIND] = BRIDGE_TABLE_FLOAT;
    putFloat(bytes.data() + BRIDGE_TABLE_RECIPROCAL, static_cast<float>(1.0 / table.stepC()));
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            putFloat(knotAt(bytes, i, axis),
                     static_cast<float>(table.tdeDps(i, static_cast<Eigen::Index>(axis))));
    }
}

class Decoder
{
public:
    Decoder(std::span<const std::uint8_t> bytes, const std::string &name) : m_bytes(bytes), m_name(name) {}

    Result<DeviceImage> decode();

private:
    Error damaged(const std::string &why) const
    {
        return Error{Errc::ModelDamaged, m_name + " is no usable device table: " + why +
                                             "; write the table into the device again."};
    }
    std::uint32_t field(std::size_t offset) const { return bridge_get_u32(m_bytes.data() + offset); }
    Status readHeader();
    Status readKnots();
    Status checkReciprocal() const;

    std::span<const std::uint8_t> m_bytes;
    std::string m_name;
    DeviceImage m_image;
};

Status Decoder::readHeader()
{
    if (m_bytes.size() < BRIDGE_TABLE_VALUES || field(BRIDGE_TABLE_MAGIC) != BRIDGE_TABLE_MAGIC_VALUE)
        return damaged("it does not begin as one (byte 0)");
    if (m_bytes[BRIDGE_TABLE_VERSION] > BRIDGE_TABLE_VERSION_VALUE) {
        return Error{Errc::ModelTooNew, m_name + " was written by a newer version of Driftbench (byte " +
                                            std::to_string(BRIDGE_TABLE_VERSION) +
                                            "); update this one to read it."};
    }
    const std::uint8_t axes = m_bytes[BRIDGE_TABLE_AXES];
    if (m_bytes[BRIDGE_TABLE_VERSION] != BRIDGE_TABLE_VERSION_VALUE || axes == 0 || axes > 7 ||
        m_bytes[BRIDGE_TABLE_THERMOMETER] > BRIDGE_THERMOMETER_EXTERNAL)
        return damaged("bytes 4 to 7 (version, kind, axes, thermometer) hold what they can't");
    CompensationTable &table = m_image.table;
    for (std::size_t axis = 0; axis < 3; ++axis)
        table.compensated[axis] = ((axes >> axis) & 1) != 0;
    m_image.thermometer = m_bytes[BRIDGE_TABLE_THERMOMETER] == BRIDGE_THERMOMETER_EXTERNAL
                              ? DeviceThermometer::External
                              : DeviceThermometer::Die;
    table.provenance.sensor = {getText(m_bytes.data() + BRIDGE_TABLE_MODEL, BRIDGE_MODEL_SIZE),
                               getText(m_bytes.data() + BRIDGE_TABLE_SERIAL, BRIDGE_SERIAL_SIZE)};
    table.firstMilliC = bridge_get_i32(m_bytes.data() + BRIDGE_TABLE_FIRST);
    table.lastMilliC = bridge_get_i32(m_bytes.data() + BRIDGE_TABLE_LAST);
    const std::uint32_t knots = field(BRIDGE_TABLE_KNOTS);
    if (knots > BRIDGE_TABLE_MOST_KNOTS ||
        m_bytes.size() != BRIDGE_TABLE_VALUES + std::size_t{knots} * BRIDGE_TABLE_KNOT_SIZE)
        return damaged(std::to_string(m_bytes.size()) + " bytes do not hold " + std::to_string(knots) +
                       " knots (byte " + std::to_string(BRIDGE_TABLE_KNOTS) + ")");
    table.tdeDps.resize(static_cast<Eigen::Index>(knots), 3);
    return {};
}

Status Decoder::readKnots()
{
    CompensationTable &table = m_image.table;
    if (m_bytes[BRIDGE_TABLE_KIND] == BRIDGE_TABLE_FIXED) {
        m_image.fixed.emplace();
        FixedPointTable &fixed = *m_image.fixed;
        fixed.firstMilliC = table.firstMilliC;
        fixed.lastMilliC = table.lastMilliC;
        fixed.reciprocal = field(BRIDGE_TABLE_RECIPROCAL);
        fixed.shift = m_bytes[BRIDGE_TABLE_SHIFT];
        fixed.fractionBits = m_bytes[BRIDGE_TABLE_FRACTION];
        fixed.values.resize(static_cast<std::size_t>(table.size()));
    } else if (m_bytes[BRIDGE_TABLE_KIND] != BRIDGE_TABLE_FLOAT) {
        return damaged("it is of no known kind (byte " + std::to_string(BRIDGE_TABLE_KIND) + ")");
    }
    for (Eigen::Index i = 0; i < table.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint8_t *at = knotAt(m_bytes, i, axis);
            double dps = 0.0;
            if (m_image.fixed) {
                const std::int32_t units = bridge_get_i32(at);
                m_image.fixed->values[static_cast<std::size_t>(i)][axis] = units;
                dps = units * m_image.fixed->dpsPerUnit();
            } else {
                dps = getFloat(at);
            }
            if (!std::isfinite(dps) || (!table.compensated[axis] && dps != 0.0))
                return damaged("knot " + std::to_string(i) + " (byte " + std::to_string(at - m_bytes.data()) +
                               ") holds what it can't");
            table.tdeDps(i, static_cast<Eigen::Index>(axis)) = dps;
        }
    }
    return {};
}

Status Decoder::checkReciprocal() const
{
    const Error contradiction =
        damaged("bytes " + std::to_string(BRIDGE_TABLE_RECIPROCAL) + " to " +
                std::to_string(BRIDGE_TABLE_FRACTION) + " do not fit its temperatures and knots");
    if (!m_image.fixed) {
        const bool fits =
            getFloat(m_bytes.data() + BRIDGE_TABLE_RECIPROCAL) ==
                static_cast<float>(1.0 / m_image.table.stepC()) &&
            m_bytes[BRIDGE_TABLE_SHIFT] == 0 && m_bytes[BRIDGE_TABLE_FRACTION] == 0 &&
            m_image.table.tdeDps.cwiseAbs().maxCoeff() < static_cast<double>(BRIDGE_TABLE_VALUE_LIMIT);
        return fits ? Status() : contradiction;
    }
    const FixedPointTable &fixed = *m_image.fixed;
    const FixedPointTable grid = makeFixedPointTable(m_image.table);
    const bool below = std::all_of(fixed.values.begin(), fixed.values.end(), [](const auto &units) {
        return std::all_of(units.begin(), units.end(), [](std::int32_t value) {
            return value > -BRIDGE_TABLE_VALUE_LIMIT && value < BRIDGE_TABLE_VALUE_LIMIT;
        });
    });
    return fixed.reciprocal == grid.reciprocal && fixed.shift == grid.shift &&
                   fixed.fractionBits <= static_cast<int>(BRIDGE_TABLE_MOST_FRACTION) && below
               ? Status()
               : contradiction;
}

Result<DeviceImage> Decoder::decode()
{
    if (const Status status = readHeader(); !status)
        return status.error();
    if (const Status status = readKnots(); !status)
        return status.error();
    if (const Status status = checkReadTable(m_image.table, m_name); !status)
        return status.error();
    if (const Status status = checkReciprocal(); !status)
        return status.error();
    return m_image;
}

} // namespace

Result<std::vector<std::uint8_t>> encodeDeviceImage(const CompensationTable &table, DeviceTableKind kind,
                                                    DeviceThermometer thermometer)
{
    assert(table.size() >= 2 && table.size() <= TableOptions::kKnotLimit && table.tdeDps.allFinite());
    if (const Status status = checkEncodable(table); !status)
        return status.error();
    std::vector<std::uint8_t> bytes(BRIDGE_TABLE_VALUES +
                                    static_cast<std::size_t>(table.size()) * BRIDGE_TABLE_KNOT_SIZE);
    putHeader(bytes, table, thermometer);
    if (kind == DeviceTableKind::FixedPoint)
        putFixed(bytes, table);
    else
        putFloats(bytes, table);
    return bytes;
}

Result<DeviceImage> decodeDeviceImage(std::span<const std::uint8_t> bytes, const std::string &name)
{
    return Decoder(bytes, name).decode();
}

std::uint32_t deviceImageCrc(std::span<const std::uint8_t> bytes)
{
    return crc32({reinterpret_cast<const char *>(bytes.data()), bytes.size()});
}

} // namespace driftbench
