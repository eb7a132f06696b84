// A HID device that the kernel can't tell from one that is plugged in, for the scenarios of tests/vm:
//
//   virtual_hid bridge SERIAL [FILE]   the reference firmware over the gyro simulator, in real time; the
//   input
//                                      reports that the kernel has taken go to FILE too, 64 bytes each
//   virtual_hid mcp2221a               an MCP2221A with an L3GD20H
//
// It is plugged in at once and goes at the end of its input. Commands, one a line, each answered by a line
// "ok", "samples N dropped M" or "what: ...":
//
//   plug, unplug
//   lose N              the next N input reports get lost on their way
//   cut N               the bridge is unplugged instead of answering its Nth exchange from now on
//   samples             how many the bridge sent since power-up, and how many it lost inside
#include "device/bridge/bridge_client.h"
#include "support/real_device.h"
#include "vm/real_time_mcp2221a.h"
#include "vm/uhid_device.h"

#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>

using namespace driftbench;
using namespace driftbench::test;

namespace {

constexpr double kProfileS = 600.0;
constexpr double kHighestRateHz =
    1000.0; // and the rate at power-up: an emulated computer has no time for more
const std::vector<std::uint8_t> kBridgeDescriptor BRIDGE_REPORT_DESCRIPTOR;

using Commands = std::map<std::string, std::function<Result<std::string>(std::int64_t)>>;

class VirtualBridge
{
public:
    VirtualBridge(const std::string &serial, const std::string &file)
    {
        if (!file.empty())
            m_sent.open(file, std::ios::binary);
        SimulatedBoardOptions options = realTimeBoard(kProfileS);
        options.simulation.sensor.serial = serial;
        options.highestRateHz = kHighestRateHz;
        m_board = *SimulatedBoard::create(std::move(options));
    }

    Result<std::string> plug()
    {
        m_board->plugIn();
        m_port.reset();
        m_transport = *SimulatedBridge::open(m_board);
        auto port = UhidDevice::create(*m_transport, kBridgeDescriptor,
                                       [this](std::span<const std::uint8_t> report) { note(report); });
        if (!port)
            return port.error();
        m_port = *std::move(port);
        return std::string("ok");
    }

    Commands commands()
    {
        return {{"plug", [this](std::int64_t) { return plug(); }},
                {"unplug", [this](std::int64_t) { return unplug(); }},
                {"lose", [this](std::int64_t count) { return lose(count); }},
                {"cut", [this](std::int64_t exchange) { return cut(exchange); }},
                {"samples", [this](std::int64_t) { return samples(); }}};
    }

private:
    void note(std::span<const std::uint8_t> report)
    {
        if (m_sent.is_open())
            m_sent.write(reinterpret_cast<const char *>(report.data()), std::ssize(report)).flush();
    }
    Result<std::string> unplug()
    {
        m_board->unplug();
        m_port.reset();
        return std::string("ok");
    }
    Result<std::string> lose(std::int64_t count)
    {
        m_board->inject([count](SimulatedFaults &faults) { faults.loseReports(0, count); });
        return std::string("ok");
    }
    Result<std::string> cut(std::int64_t exchange)
    {
        m_board->inject([exchange](SimulatedFaults &faults) { faults.unplugAtExchange(exchange); });
        return std::string("ok");
    }
    Result<std::string> samples()
    {
        SteadyClock clock;
        auto transport = SimulatedBridge::open(m_board);
        if (!transport)
            return transport.error();
        auto client = BridgeClient::open(*std::move(transport), clock);
        if (!client)
            return client.error();
        const auto status = client->status();
        if (!status)
            return status.error();
        return "samples " + std::to_string(status->producedSamples) + " dropped " +
               std::to_string(status->droppedSamples);
    }

    std::ofstream m_sent;
    std::shared_ptr<SimulatedBoard> m_board;
    std::unique_ptr<HidTransport> m_transport;
    std::unique_ptr<UhidDevice> m_port;
};

class VirtualMcp2221a
{
public:
    Result<std::string> plug()
    {
        m_port.reset();
        auto port = UhidDevice::create(m_device, RealTimeMcp2221a::descriptor());
        if (!port)
            return port.error();
        m_port = *std::move(port);
        return std::string("ok");
    }

    Commands commands()
    {
        return {{"plug", [this](std::int64_t) { return plug(); }}, {"unplug", [this](std::int64_t) {
                                                                        m_port.reset();
                                                                        return Result<std::string>("ok");
                                                                    }}};
    }

private:
    RealTimeMcp2221a m_device;
    std::unique_ptr<UhidDevice> m_port;
};

bool tell(const Result<std::string> &answer)
{
    std::cout << (answer ? *answer : "what: " + answer.error().message) << std::endl;
    return answer.ok();
}

Result<std::string> obey(const Commands &commands, const std::string &line)
{
    std::istringstream words(line);
    std::string name;
    std::int64_t number = 0;
    words >> name >> number;
    const auto found = commands.find(name);
    if (found == commands.end())
        return Error{Errc::InvalidOption, "there is no \"" + name + "\" here"};
    return found->second(number);
}

template <class Device>
int run(Device &device)
{
    if (!tell(device.plug()))
        return 1;
    const Commands commands = device.commands();
    for (std::string line; std::getline(std::cin, line);)
        tell(obey(commands, line));
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if ((arguments.size() == 2 || arguments.size() == 3) && arguments[0] == "bridge") {
        VirtualBridge bridge(arguments[1], arguments.size() == 3 ? arguments[2] : std::string());
        return run(bridge);
    }
    if (arguments.size() == 1 && arguments[0] == "mcp2221a") {
        VirtualMcp2221a chip;
        return run(chip);
    }
    std::cerr << "usage: virtual_hid bridge SERIAL [FILE] | mcp2221a" << std::endl;
    return 2;
}
