#include "app/cli/exit_codes.h"

#include "engine/base/result.h"

#include <array>
#include <string_view>

namespace driftbench::cli {

namespace {

struct Meaning
{
    int code;
    std::string_view text;
};

constexpr Meaning meaning(Errc code, std::string_view text)
{
    return {static_cast<int>(code), text};
}

constexpr auto kMeanings = std::to_array<Meaning>({
    {kExitSuccess, "done"},
    {kExitUnexpected, "an error of the program itself"},
    {kExitUsage, "the command line is not understood"},
    meaning(Errc::FileNotFound, "no such file"),
    meaning(Errc::FileUnreadable, "file can't be read"),
    meaning(Errc::FileEmpty, "file is empty"),
    meaning(Errc::UnknownFormat, "format not recognised"),
    meaning(Errc::MissingColumn, "column missing"),
    meaning(Errc::NotANumber, "text where a number should be"),
    meaning(Errc::DamagedLog, "damaged log"),
    meaning(Errc::NoSuchInstance, "no such sensor instance in the log"),
    meaning(Errc::TooFewSamples, "too few samples"),
    meaning(Errc::TooShort, "recording too short"),
    meaning(Errc::ConstantTemperature, "temperature does not change"),
    meaning(Errc::SpanTooSmall, "temperature span too small"),
    meaning(Errc::TimeBackwards, "time goes backwards"),
    meaning(Errc::NonFiniteValue, "values that are not finite"),
    meaning(Errc::UnitsDiffer, "units differ or are implausible"),
    meaning(Errc::DifferentSensors, "runs of different sensors"),
    meaning(Errc::SameRecordingTwice, "the same recording twice"),
    meaning(Errc::NothingUsable, "nothing usable in the recording"),
    meaning(Errc::OutputNotWritable, "output can't be written"),
    meaning(Errc::OutputFull, "no room left for the output"),
    meaning(Errc::ModelDamaged, "model file damaged"),
    meaning(Errc::ModelEdited, "model file edited"),
    meaning(Errc::ModelTooNew, "model file of a newer version"),
    meaning(Errc::ModelOfAnotherSensor, "model of another sensor"),
    meaning(Errc::OutsideTrainedRange, "outside the trained temperature range"),
    meaning(Errc::ModelNotUsableHere, "this model can't be used for that"),
    meaning(Errc::VerdictForbids, "the verdict forbids it"),
    meaning(Errc::InvalidOption, "the value of an option can't be"),
    meaning(Errc::PlanDamaged, "plan file damaged"),
    meaning(Errc::Cancelled, "cancelled"),
    meaning(Errc::DeviceNotFound, "no such device"),
    meaning(Errc::DeviceNotPermitted, "device found, but not permitted"),
    meaning(Errc::DeviceHeldByKernel, "a kernel driver holds the device"),
    meaning(Errc::DeviceInUse, "another program holds the device"),
    meaning(Errc::DeviceUnplugged, "device unplugged"),
    meaning(Errc::DeviceSilent, "device does not answer"),
    meaning(Errc::DeviceRefused, "device refused"),
    meaning(Errc::ProtocolVersion, "another version of the bridge protocol"),
    meaning(Errc::WrongSensor, "another sensor than expected"),
    meaning(Errc::BusNoAcknowledge, "nothing answers on the I2C bus at that address"),
    meaning(Errc::BusStuck, "I2C bus stuck"),
    meaning(Errc::DamagedReport, "damaged report from the device"),
    meaning(Errc::TableMismatch, "table on the device differs from what was written"),
    meaning(Errc::SessionDamaged, "session file damaged"),
    meaning(Errc::SessionTooNew, "session file of a newer version"),
    meaning(Errc::SessionReadOnly, "session file opened read-only"),
    meaning(Errc::SessionInUse, "another program holds the session file"),
    meaning(Errc::NoSuchRun, "no such run or model in the session"),
});

} // namespace

std::string exitCodeList()
{
    std::string list = "Exit codes:\n";
    for (const auto &[code, text] : kMeanings)
        list += (code < 10    ? "    "
                 : code < 100 ? "   "
                              : "  ") +
                std::to_string(code) + "  " + std::string(text) + "\n";
    return list;
}

} // namespace driftbench::cli
