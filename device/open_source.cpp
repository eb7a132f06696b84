#include "device/open_source.h"

#include "device/bridge/bridge_source.h"
#include "device/discovery/device_match.h"
#include "device/gyros/gyro_i2c_source.h"
#include "device/replay_source.h"
#include "device/simulated_bridge.h"
#include "engine/physics/drift_curves.h"
#include "engine/physics/sensor_presets.h"

namespace driftbench {

namespace {

KernelReports kernelReports(const HidAccess &access)
{
    return [&access](UsbId id) { return kernelDriverState(access.sysfs, id.vendorId, id.productId); };
}

// A transport with what it needs and the way to another one like it.
struct Connection
{
    std::shared_ptr<SimulatedBoard> board;
    std::unique_ptr<HostClock> ownClock;
    HostClock *clock = nullptr;
    HidIdentity identity;
    std::unique_ptr<HidTransport> transport;
    ReopenTransport reopen;
};

Result<Connection> openHid(const HidIdentity &identity, const HidAccess &access)
{
    auto transport = access.open(identity);
    if (!transport)
        return transport.error();
    Connection made;
    if (!access.clock)
        made.ownClock = std::make_unique<SteadyClock>();
    made.clock = access.clock ? access.clock : made.ownClock.get();
    made.identity = identity;
    made.transport = *std::move(transport);
    return made;
}

// To the same serial number, wherever it is plugged in; one without is known by its gyro alone.
ReopenTransport reopenNative(const HidIdentity &identity, const HidAccess &access)
{
    const NativeChoice again{identity.serial, {{identity.vendorId, identity.productId}}};
    return [again, access]() -> Result<std::unique_ptr<HidTransport>> {
        const auto found = findNativeBridge(access.list(), again, kernelReports(access));
        if (!found)
            return found.error();
        return access.open(*found);
    };
}

Result<Connection> connect(const NativeChoice &choice, const HidAccess &access)
{
    const auto found = findNativeBridge(access.list(), choice, kernelReports(access));
    if (!found)
        return found.error();
    auto made = openHid(*found, access);
    if (made)
        made->reopen = reopenNative(*found, access);
    return made;
}

Result<SimulationOptions> simulationOf(const SimulatedChoice &choice)
{
    auto simulation = presetSimulation(choice.sensor, choice.referenceRateDps);
    if (!simulation)
        return simulation;
    if (!choice.serial.empty())
        simulation->sensor.serial = choice.serial;
    if (choice.profile)
        simulation->profile = *choice.profile;
    if (!choice.drift.empty()) {
        auto curves = namedDriftCurves(choice.drift);
        if (!curves)
            return curves.error();
        simulation->truth = *std::move(curves);
        simulation->combs.reset();
    }
    simulation->seed = choice.seed;
    simulation->gyro.noiseDps = choice.noiseDps.value_or(simulation->gyro.noiseDps);
    simulation->gyro.spread = choice.spread.value_or(simulation->gyro.spread);
    return simulation;
}

Result<Connection> connect(const SimulatedChoice &choice)
{
    auto simulation = simulationOf(choice);
    if (!simulation)
        return simulation.error();
    SimulatedBoardOptions options{*std::move(simulation)};
    options.speed = choice.speed;
    options.clockErrorPpm = choice.clockErrorPpm;
    options.externalThermometer = choice.externalThermometer;
    options.flashFile = choice.flashFile;
    options.firstRun = choice.run;
    const auto board = SimulatedBoard::create(std::move(options));
    if (!board)
        return board.error();
    auto transport = SimulatedBridge::open(*board);
    if (!transport)
        return transport.error();
    Connection made;
    made.board = *board;
    made.clock = &(*board)->clock();
    made.identity = (*board)->identity();
    made.transport = *std::move(transport);
    made.reopen = [board = *board] { return SimulatedBridge::open(board); };
    return made;
}

BridgeThermometer bridgeThermometer(ThermometerChoice choice)
{
    switch (choice) {
    case ThermometerChoice::Automatic:
        break;
    case ThermometerChoice::External:
        return BridgeThermometer::External;
    case ThermometerChoice::Die:
        return BridgeThermometer::Die;
    }
    return BridgeThermometer::Automatic;
}

Result<OpenedSource> openBridgeSource(Connection connection, const SourceChoice &choice)
{
    BridgeSourceOptions options;
    options.rateHz = choice.rateHz;
    options.rangeDps = choice.rangeDps;
    options.compensate = choice.compensate;
    options.thermometer = bridgeThermometer(choice.thermometer);
    options.reopen = std::move(connection.reopen);
    auto source = BridgeSource::open(std::move(connection.transport), *connection.clock, std::move(options));
    if (!source)
        return source.error();
    OpenedSource opened{connection.board, std::move(connection.ownClock), connection.identity};
    opened.bridge = &(*source)->client();
    opened.source = *std::move(source);
    opened.isRealTime = connection.board == nullptr;
    return opened;
}

Result<OpenedSource> openSimulated(const SimulatedChoice &simulated, SourceChoice choice)
{
    auto connection = connect(simulated);
    if (!connection)
        return connection.error();
    // The bridge starts at its highest rate, which fits few profiles.
    if (choice.rateHz == 0.0)
        choice.rateHz = presetSimulation(simulated.sensor, simulated.referenceRateDps)->gyro.sampleRateHz;
    return openBridgeSource(*std::move(connection), choice);
}

GyroI2cOptions gyroOptions(const I2cChoice &i2c, const SourceChoice &choice)
{
    GyroI2cOptions options;
    options.model = i2c.gyro;
    options.address = i2c.gyroAddress;
    options.serial = i2c.gyroSerial;
    if (choice.rateHz != 0.0)
        options.gyro.rateHz = choice.rateHz;
    if (choice.rangeDps != 0.0)
        options.gyro.rangeDps = choice.rangeDps;
    options.temperature.dieOffsetC = i2c.dieOffsetC;
    options.temperature.dieCPerCount = i2c.dieCPerCount;
    options.temperature.useExternal = choice.thermometer != ThermometerChoice::Die;
    options.temperature.requireExternal = choice.thermometer == ThermometerChoice::External;
    options.temperature.externalModel = i2c.thermometer;
    options.temperature.externalAddress = i2c.thermometerAddress;
    return options;
}

Result<OpenedSource> openI2c(const I2cChoice &i2c, const SourceChoice &choice, const HidAccess &access)
{
    if (choice.compensate)
        return invalidOption(
            "A gyro behind an I2C bridge has no compensation table; record without --compensate "
            "and apply the model to the log.");
    const auto found = findI2cChip(access.list(), i2c, kernelReports(access));
    if (!found)
        return found.error();
    auto connection = openHid(*found, access);
    if (!connection)
        return connection.error();
    auto bus = openI2cChip(i2c.chip, std::move(connection->transport), i2c.busKHz);
    if (!bus)
        return bus.error();
    auto source = GyroI2cSource::open(*std::move(bus), gyroOptions(i2c, choice), *connection->clock);
    if (!source)
        return source.error();
    OpenedSource opened{nullptr, std::move(connection->ownClock), *found};
    opened.source = *std::move(source);
    opened.isRealTime = true;
    return opened;
}

Result<OpenedSource> openFile(const FileChoice &file, const SourceChoice &choice)
{
    if (choice.rateHz != 0.0 || choice.rangeDps != 0.0 || choice.compensate ||
        choice.thermometer != ThermometerChoice::Automatic)
        return invalidOption(
            "A log is played back as it was recorded; rate, range, thermometer and compensation "
            "can't be chosen for " +
            file.path.string() + ".");
    auto clock = std::make_unique<SteadyClock>();
    auto source = ReplaySource::open(file.path, *clock, {file.speed, ReplayOptions{}.blockS, file.read});
    if (!source)
        return source.error();
    OpenedSource opened{nullptr, std::move(clock)};
    opened.source = *std::move(source);
    return opened;
}

Status checkOptions(const SourceChoice &choice)
{
    for (const double figure : {choice.rateHz, choice.rangeDps}) {
        if (!(figure >= 0.0 && figure <= 1e9))
            return invalidOption("Rate and range must be more than 0.");
    }
    return {};
}

} // namespace

Result<OpenedSource> openSource(const SourceChoice &choice, const HidAccess &access)
{
    if (const Status ok = checkOptions(choice); !ok)
        return ok.error();
    if (const auto *simulated = choice.as<SimulatedChoice>())
        return openSimulated(*simulated, choice);
    if (const auto *i2c = choice.as<I2cChoice>())
        return openI2c(*i2c, choice, access);
    if (const auto *file = choice.as<FileChoice>())
        return openFile(*file, choice);
    auto connection = connect(std::get<NativeChoice>(choice.from), access);
    if (!connection)
        return connection.error();
    return openBridgeSource(*std::move(connection), choice);
}

Result<OpenedBridge> openBridge(const SourceChoice &choice, const HidAccess &access)
{
    const auto *simulated = choice.as<SimulatedChoice>();
    const auto *native = choice.as<NativeChoice>();
    if (!simulated && !native)
        return invalidOption(
            "\"" + sourceChoiceText(choice) +
            "\" is no native gyro bridge, and only those have settings and tables; say simulated, "
            "hid, or hid: and a serial number.");
    auto connection = simulated ? connect(*simulated) : connect(*native, access);
    if (!connection)
        return connection.error();
    auto client = BridgeClient::open(std::move(connection->transport), *connection->clock);
    if (!client)
        return client.error();
    return OpenedBridge{connection->board, std::move(connection->ownClock),
                        std::make_unique<BridgeClient>(*std::move(client))};
}

} // namespace driftbench
