#include "device/source_choice.h"

#include "device/gyros/st_gyro_registers.h"
#include "engine/base/text.h"

#include <charconv>
#include <cmath>

namespace driftbench {

namespace {

// Before and after the first or last separator; nothing after it if there is none.
struct Parts
{
    std::string_view head;
    std::optional<std::string_view> tail;
};

Parts splitAt(std::string_view text, std::size_t at)
{
    if (at == std::string_view::npos)
        return {text, std::nullopt};
    return {text.substr(0, at), text.substr(at + 1)};
}

std::optional<unsigned> hexNumber(std::string_view text, unsigned largest)
{
    if (text.starts_with("0x") || text.starts_with("0X"))
        text.remove_prefix(2);
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (error != std::errc() || end != text.data() + text.size() || value > largest)
        return std::nullopt;
    return value;
}

std::string hexWord(unsigned value)
{
    std::string text;
    for (int shift = 12; shift >= 0; shift -= 4)
        text += "0123456789abcdef"[value >> shift & 15];
    return text;
}

// "l3gd20h@6b"
struct NameAtAddress
{
    std::string name;
    std::uint8_t address = 0;
};

Result<NameAtAddress> parseNameAtAddress(std::string_view text)
{
    const auto [name, address] = splitAt(text, text.find('@'));
    NameAtAddress parsed{lowered(name)};
    if (!address)
        return parsed;
    const auto number = hexNumber(*address, 0x7F);
    if (!number || *number == 0)
        return invalidOption("\"" + std::string(*address) +
                             "\" is no I2C address; give 7 bits in hex, like 6b or 0x6b.");
    parsed.address = static_cast<std::uint8_t>(*number);
    return parsed;
}

Status takeGyro(I2cChoice &choice, std::string_view text)
{
    const auto parsed = parseNameAtAddress(text);
    if (!parsed)
        return parsed.error();
    choice.gyroAddress = parsed->address;
    if (parsed->name == "auto")
        return {};
    std::string known;
    for (const st_gyro::Description &gyro : st_gyro::descriptions()) {
        if (lowered(gyro.model) == parsed->name)
            choice.gyro = gyro.model;
        known += lowered(gyro.model) + ", ";
    }
    if (choice.gyro.empty())
        return invalidOption("There is no gyro \"" + parsed->name + "\" for an I2C bridge; say " + known +
                             "or auto for whichever answers.");
    return {};
}

Status takeThermometer(SourceChoice &choice, I2cChoice &i2c, std::string_view text)
{
    const auto parsed = parseNameAtAddress(text);
    if (!parsed)
        return parsed.error();
    i2c.thermometerAddress = parsed->address;
    choice.thermometer = ThermometerChoice::External;
    if (parsed->name == "tmp117")
        i2c.thermometer = ThermometerModel::Tmp117;
    else if (parsed->name == "mcp9808")
        i2c.thermometer = ThermometerModel::Mcp9808;
    else if (parsed->name == "die")
        choice.thermometer = ThermometerChoice::Die;
    else if (parsed->name != "any")
        return invalidOption("There is no thermometer \"" + parsed->name +
                             "\"; say tmp117, mcp9808, any or die.");
    if (!i2c.thermometer && parsed->address != 0)
        return invalidOption("An address needs a thermometer whose name is known, like tmp117@48.");
    return {};
}

Result<SourceChoice> parseI2c(std::string_view text)
{
    constexpr std::string_view kHow =
        "say i2c:CHIP/GYRO, like i2c:mcp2221a/l3gd20h+tmp117 or i2c:cp2112:SERIAL/auto.";
    // A serial number may be a path: the gyro stands behind the last slash.
    const auto [bridge, sensors] = splitAt(text, text.rfind('/'));
    if (!sensors || sensors->empty())
        return invalidOption("\"i2c:" + std::string(text) + "\" names no gyro; " + std::string(kHow));
    const auto [chipName, serial] = splitAt(bridge, bridge.find(':'));
    const auto chip = i2cChipNamed(chipName);
    if (!chip)
        return invalidOption("There is no bridge \"" + std::string(chipName) + "\"; " + std::string(kHow));
    SourceChoice choice{I2cChoice{*chip, std::string(serial.value_or(""))}};
    I2cChoice &i2c = *choice.as<I2cChoice>();
    const auto [gyro, thermometer] = splitAt(*sensors, sensors->find('+'));
    if (const Status ok = takeGyro(i2c, gyro); !ok)
        return ok.error();
    if (thermometer) {
        if (const Status ok = takeThermometer(choice, i2c, *thermometer); !ok)
            return ok.error();
    }
    return choice;
}

Result<SourceChoice> parseSimulated(std::string_view text)
{
    const auto [sensor, serial] = splitAt(text, text.find(':'));
    SimulatedChoice simulated;
    if (!sensor.empty())
        simulated.sensor = sensor;
    simulated.serial = serial.value_or("");
    return SourceChoice{simulated};
}

Result<SourceChoice> parseFile(std::string_view text)
{
    FileChoice file{std::string(text)};
    const auto [path, speed] = splitAt(text, text.rfind('*'));
    if (const auto number = speed ? parseNumber(*speed) : std::nullopt) {
        if (!(*number >= 0.0) || !std::isfinite(*number))
            return invalidOption("A log can't be played back " + std::string(*speed) +
                                 " times as fast; give a number above 0, or 0 for as fast as it goes.");
        file.path = std::string(path);
        file.speed = *number;
    }
    if (file.path.empty())
        return invalidOption("\"file:" + std::string(text) +
                             "\" names no log; say file:PATH or file:PATH*SPEED.");
    return SourceChoice{file};
}

std::string atAddress(std::uint8_t address)
{
    return address == 0 ? "" : "@" + hexByte(address);
}

std::string thermometerText(const I2cChoice &i2c, ThermometerChoice choice)
{
    if (choice == ThermometerChoice::Automatic)
        return "";
    if (choice == ThermometerChoice::Die)
        return "+die";
    return "+" + (i2c.thermometer ? lowered(thermometerName(*i2c.thermometer)) : "any") +
           atAddress(i2c.thermometerAddress);
}

std::string withSerial(std::string text, const std::string &serial)
{
    return serial.empty() ? text : text + ":" + serial;
}

} // namespace

Result<UsbId> parseUsbId(std::string_view text)
{
    const auto [vendorText, productText] = splitAt(text, text.find(':'));
    const auto vendor = hexNumber(vendorText, 0xFFFF);
    const auto product = productText ? hexNumber(*productText, 0xFFFF) : std::nullopt;
    if (!vendor || !product)
        return invalidOption("\"" + std::string(text) +
                             "\" is no USB id; give vendor and product in hex, like 1209:0001.");
    return UsbId{static_cast<std::uint16_t>(*vendor), static_cast<std::uint16_t>(*product)};
}

std::string usbIdText(UsbId id)
{
    return hexWord(id.vendorId) + ":" + hexWord(id.productId);
}

Result<SourceChoice> parseSourceChoice(std::string_view text)
{
    const auto [kindText, restGiven] = splitAt(text, text.find(':'));
    const std::string kind = lowered(kindText);
    const std::string_view rest = restGiven.value_or("");
    if (kind == "simulated")
        return parseSimulated(rest);
    if (kind == "hid")
        return SourceChoice{NativeChoice{std::string(rest)}};
    if (kind == "i2c")
        return parseI2c(rest);
    if (kind == "file")
        return parseFile(rest);
    return invalidOption("\"" + std::string(text) +
                         "\" is no source; say simulated, hid, hid:SERIAL, i2c:CHIP/GYRO or file:PATH.");
}

std::string sourceChoiceText(const SourceChoice &choice)
{
    if (const auto *simulated = choice.as<SimulatedChoice>())
        return withSerial("simulated:" + simulated->sensor, simulated->serial);
    if (const auto *native = choice.as<NativeChoice>())
        return withSerial("hid", native->serial);
    if (const auto *i2c = choice.as<I2cChoice>())
        return withSerial("i2c:" + std::string(describe(i2c->chip).key), i2c->serial) + "/" +
               (i2c->gyro.empty() ? "auto" : lowered(i2c->gyro)) + atAddress(i2c->gyroAddress) +
               thermometerText(*i2c, choice.thermometer);
    const auto &file = std::get<FileChoice>(choice.from);
    const std::string path = file.path.string();
    // A star in the name must not be taken for that of the speed.
    const bool sayNothing = file.speed == 1.0 && path.find('*') == std::string::npos;
    return "file:" + path + (sayNothing ? "" : "*" + shortest(file.speed));
}

} // namespace driftbench
