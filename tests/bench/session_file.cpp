// driftbench-session-bench FOLDER: what recording into a session file costs, and how fast one is opened and
// read. The samples are those of a gyro at 10 kHz: counts at 8.75 mdps, hundredths of a degree, microseconds.
#include "app/session/session_file.h"
#include "app/session/database.h"
#include "app/session/run_recorder.h"
#include "bench/gyro_stream.h"

#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace driftbench;
using bench::fail;
using bench::need;

namespace {

constexpr double kRateHz = bench::GyroStream::kRateHz;
constexpr Eigen::Index kBlock = 400;          // 40 ms
constexpr std::int64_t kRecorded = 6'000'000; // 10 minutes
constexpr std::int64_t kLarge = 50'000'000;
constexpr double kSpeed = 20.0; // times real time, at which the recorder is fed

double nowS()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processorS(int whose = RUSAGE_SELF)
{
    rusage usage{};
    ::getrusage(whose, &usage);
    const auto seconds = [](const timeval &t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peakMegabytes()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void record(const std::filesystem::path &path, const bench::GyroStream &stream)
{
    auto file = need(SessionFile::create(path));
    SourceInfo source{"benchmark", {"L3GD20H", "BENCH"}, kRateHz, 245.0, true, false};
    SampleBlock block = SampleBlock::withRows(kBlock);
    const double processorBefore = processorS();
    const double started = nowS();
    double feedingS = 0.0;
    RunId run = 0;
    {
        RecorderOptions options;
        options.commitEveryS /= kSpeed; // as many commits a second of the stream as in real time
        auto recorder = need(RunRecorder::start(file, describeSource(source, "run"), options));
        run = recorder->run();
        for (std::int64_t at = 0; at < kRecorded; at += kBlock) {
            const double feed = processorS(RUSAGE_THREAD);
            stream.fill(at, kBlock, block.timeS.data(), block.temperatureC.data(), block.rateDps, 0);
            feedingS += processorS(RUSAGE_THREAD) - feed;
            recorder->samples(block, kBlock);
            const double aheadS = static_cast<double>(at) / kRateHz / kSpeed - (nowS() - started);
            if (aheadS > 0.002)
                std::this_thread::sleep_for(std::chrono::duration<double>(aheadS));
        }
        if (const Status finished = recorder->finish(); !finished)
            fail(finished.error().message);
        const RecorderStats stats = recorder->stats();
        std::printf(
            "record: %lld samples taken, %lld written, %lld commits, longest %.3f s, most waiting %.1f MB\n",
            static_cast<long long>(stats.taken), static_cast<long long>(stats.written),
            static_cast<long long>(stats.commits), stats.longestCommitS,
            static_cast<double>(stats.largestQueuedBytes) / 1e6);
    }
    const double usedS = processorS() - processorBefore - feedingS;
    std::printf("record: %.2f %% of a core, %.0f MB of memory at most\n",
                usedS / (static_cast<double>(kRecorded) / kRateHz) * 100.0, peakMegabytes());
    const Recording back = need(file.readRun(run));
    SampleBlock same = SampleBlock::withRows(kBlock);
    std::int64_t different = back.size() == kRecorded ? 0 : kRecorded;
    for (std::int64_t at = 0; different == 0 && at < kRecorded; at += kBlock) {
        stream.fill(at, kBlock, same.timeS.data(), same.temperatureC.data(), same.rateDps, 0);
        const bool equal = same.timeS == back.timeS.segment(at, kBlock) &&
                           same.temperatureC == back.temperatureC.segment(at, kBlock) &&
                           same.rateDps == back.rateDps.middleRows(at, kBlock);
        different += equal ? 0 : kBlock;
    }
    std::printf("record: %lld samples differ\n", static_cast<long long>(different));
}

void makeLarge(const std::filesystem::path &path, const bench::GyroStream &stream)
{
    const double started = nowS();
    bench::importStream(path, stream, kLarge);
    std::printf("import: %.1f M samples made and written in %.1f s\n", static_cast<double>(kLarge) / 1e6,
                nowS() - started);
}

// The bytes of the file alone, 1 MiB at a time: the disk's speed where the system has been told to forget it.
void readRaw(const std::filesystem::path &path, bool forget)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        fail("can't open " + path.string());
    if (forget) {
        ::fsync(descriptor);
        ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    }
    std::vector<char> buffer(1 << 20);
    const double started = nowS();
    double megabytes = 0.0;
    for (ssize_t got = 1; got > 0; megabytes += static_cast<double>(got) / 1e6)
        got = ::read(descriptor, buffer.data(), buffer.size());
    const double tookS = nowS() - started;
    std::printf("raw: %.0f MB %s in %.2f s: %.0f MB/s\n", megabytes,
                forget ? "from the disk" : "from the system's memory", tookS, megabytes / tookS);
    if (forget)
        ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    ::close(descriptor);
}

void showOverview(const std::filesystem::path &path)
{
    const auto file = need(SessionFile::open(path, SessionAccess::ReadOnly));
    const double started = nowS();
    const RunOverview overview = need(file.overview(1));
    std::printf("overview: %lld rows in %.3f s, from a file of version %d\n",
                static_cast<long long>(overview.size()), nowS() - started, file.formatVersion());
}

// From stored overviews back to a file without, and forth.
void migrateLarge(const std::filesystem::path &path)
{
    showOverview(path);
    {
        const auto database = need(Database::open(path, DatabaseMode::ReadWrite));
        if (const Status old = database.script("DROP TABLE overview; PRAGMA user_version = 1;"); !old)
            fail(old.error().message);
    }
    showOverview(path);
    const double started = nowS();
    const double processorBefore = processorS();
    need(SessionFile::open(path, SessionAccess::ReadWrite));
    std::printf("migrate: %.2f s, %.2f s of a core\n", nowS() - started, processorS() - processorBefore);
    showOverview(path);
}

void readLarge(const std::filesystem::path &path)
{
    readRaw(path, true);
    double started = nowS();
    const auto file = need(SessionFile::open(path, SessionAccess::ReadWrite));
    const auto runs = need(file.runs());
    std::printf("open: %lld samples in %.4f s\n", static_cast<long long>(runs[0].samples), nowS() - started);
    for (int time = 0; time < 3; ++time) {
        if (time > 0)
            readRaw(path, false);
        started = nowS();
        const double processorBefore = processorS();
        const Recording back = need(file.readRun(runs[0].id));
        const double megabytes = static_cast<double>(back.size()) * 40.0 / 1e6;
        std::printf("read: %.0f MB of columns in %.2f s: %.0f MB/s; %.0f MB per second of a core\n",
                    megabytes, nowS() - started, megabytes / (nowS() - started),
                    megabytes / (processorS() - processorBefore));
    }
}

void size(const char *what, const std::filesystem::path &path, std::int64_t samples)
{
    const auto bytes = static_cast<double>(std::filesystem::file_size(path));
    std::printf("%s: %.1f MB on disk, %.2f bytes a sample\n", what, bytes / 1e6,
                bytes / static_cast<double>(samples));
}

} // namespace

int main(int argc, char **argv)
{
    const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
    const bench::GyroStream stream;
    const auto recorded = folder / "recorded.driftbench";
    const auto large = folder / "large.driftbench";
    std::filesystem::remove(recorded);
    std::filesystem::remove(large);
    record(recorded, stream);
    size("record", recorded, kRecorded);
    makeLarge(large, stream);
    size("large", large, kLarge);
    readLarge(large);
    migrateLarge(large);
    std::filesystem::remove(recorded);
    std::filesystem::remove(large);
}
