// Errors that input, device or data can cause are values: Result<T> holds either a T or an Error.
//
// An Error carries a code, by which programs decide, and one sentence for the user: what, where (file, line,
// byte), what to do. Each code is also the exit status of driftbench-cli (README.md).
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace driftbench {

// The numbers are part of the command line's contract: add, never renumber.
enum class Errc
{
    FileNotFound = 10,
    FileUnreadable = 11,
    FileEmpty = 12,
    UnknownFormat = 13,
    MissingColumn = 14,
    NotANumber = 15,
    DamagedLog = 16,
    NoSuchInstance = 17,

    TooFewSamples = 20,
    TooShort = 21,
    ConstantTemperature = 22,
    SpanTooSmall = 23,
    TimeBackwards = 24,
    NonFiniteValue = 25,
    UnitsDiffer = 26,
    DifferentSensors = 27,
    SameRecordingTwice = 28,
    NothingUsable = 29,

    OutputNotWritable = 30,
    OutputFull = 31,

    ModelDamaged = 40,
    ModelEdited = 41,
    ModelTooNew = 42,
    ModelOfAnotherSensor = 43,
    OutsideTrainedRange = 44,
    ModelNotUsableHere = 45,

    VerdictForbids = 50,
    InvalidOption = 60,
    PlanDamaged = 61,
    Cancelled = 70,

    DeviceNotFound = 80,
    DeviceNotPermitted = 81,
    DeviceHeldByKernel = 82,
    DeviceInUse = 83,
    DeviceUnplugged = 84,
    DeviceSilent = 85,
    DeviceRefused = 86,
    ProtocolVersion = 87,
    WrongSensor = 88,
    BusNoAcknowledge = 89,
    BusStuck = 90,
    DamagedReport = 91,
    TableMismatch = 92,

    SessionDamaged = 100,
    SessionTooNew = 101,
    SessionReadOnly = 102,
    SessionInUse = 103,
    NoSuchRun = 104,
};

struct Error
{
    Errc code;
    std::string message; // one sentence, ends with a full stop
};

inline Error invalidOption(std::string message)
{
    return {Errc::InvalidOption, std::move(message)};
}

template <class T>
class [[nodiscard]] Result
{
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    const T &value() const &
    {
        assert(ok());
        return *std::get_if<0>(&m_state);
    }
    T &value() &
    {
        assert(ok());
        return *std::get_if<0>(&m_state);
    }
    T &&value() &&
    {
        assert(ok());
        return std::move(*std::get_if<0>(&m_state));
    }
    const T &operator*() const & { return value(); }
    T &operator*() & { return value(); }
    T &&operator*() && { return std::move(*this).value(); }
    const T *operator->() const { return &value(); }
    T *operator->() { return &value(); }

    const Error &error() const
    {
        assert(!ok());
        return *std::get_if<1>(&m_state);
    }

private:
    std::variant<T, Error> m_state;
};

// The result of something that has no value but can fail.
class [[nodiscard]] Status
{
public:
    Status() = default;
    Status(Error error) : m_error(std::move(error)), m_ok(false) {}

    bool ok() const { return m_ok; }
    explicit operator bool() const { return m_ok; }
    const Error &error() const
    {
        assert(!m_ok);
        return m_error;
    }

private:
    Error m_error{};
    bool m_ok = true;
};

} // namespace driftbench
