// CSV -> recording, in bytes per second, against touching every byte once.
#include "engine/base/random.h"
#include "engine/formats/csv_writer.h"
#include "engine/formats/file_window.h"
#include "engine/formats/log_reader.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <unistd.h>

using namespace driftbench;

namespace {

// Five runs of the paper: 555 000 rows with the digits that logs have.
class CampaignFile
{
public:
    CampaignFile()
        : m_path(std::filesystem::temp_directory_path() /
                 ("driftbench-bench-" + std::to_string(::getpid()) + ".csv"))
    {
        constexpr Eigen::Index kRows = 555000;
        Random random(1);
        Recording campaign;
        campaign.timeS = Eigen::VectorXd::LinSpaced(kRows, 0.0, 0.1 * (kRows - 1));
        campaign.temperatureC =
            campaign.timeS.unaryExpr([](double timeS) { return 22.5 + 62.5 * std::sin(timeS / 1800.0); });
        campaign.rateDps =
            Eigen::MatrixX3d::NullaryExpr(kRows, 3, [&] { return 3.0 + 0.14 * random.normal(); });
        m_written = writeCsv(m_path, campaign, {.time = 6, .temperature = 5, .rate = 7}).ok();
    }
    ~CampaignFile() { std::filesystem::remove(m_path); }
    CampaignFile(const CampaignFile &) = delete;
    CampaignFile &operator=(const CampaignFile &) = delete;

    const std::filesystem::path &path() const { return m_path; }
    bool written() const { return m_written; }

private:
    std::filesystem::path m_path;
    bool m_written = false;
};

const CampaignFile &campaignFile()
{
    static const CampaignFile file;
    return file;
}

void countBytes(benchmark::State &state)
{
    const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(campaignFile().path()));
    state.SetBytesProcessed(bytes * static_cast<std::int64_t>(state.iterations()));
}

void csvToRecording(benchmark::State &state)
{
    if (!campaignFile().written())
        return state.SkipWithError("the file could not be written");
    for (auto _ : state) {
        const auto recording = readLog(campaignFile().path(), {});
        if (!recording)
            return state.SkipWithError(recording.error().message.c_str());
        benchmark::DoNotOptimize(recording->rateDps.data());
    }
    countBytes(state);
}

void csvBlocks(benchmark::State &state)
{
    for (auto _ : state) {
        double sum = 0.0;
        const auto info = readLogBlocks(campaignFile().path(), {}, [&](const SampleBlock &block) {
            sum += block.rateDps(0, 0);
            return Flow::Continue;
        });
        if (!info)
            return state.SkipWithError(info.error().message.c_str());
        benchmark::DoNotOptimize(sum);
    }
    countBytes(state);
}

// What no reader can beat: the file through the window, every byte looked at.
void csvLinesOnly(benchmark::State &state)
{
    for (auto _ : state) {
        auto window = FileWindow::open(campaignFile().path());
        if (!window)
            return state.SkipWithError(window.error().message.c_str());
        std::int64_t lines = 0;
        while (window->fill(1)) {
            window->fill(FileWindow::kDefaultBytes);
            lines += std::count(window->bytes().begin(), window->bytes().end(), '\n');
            window->consume(window->bytes().size());
        }
        benchmark::DoNotOptimize(lines);
    }
    countBytes(state);
}

void csvWriting(benchmark::State &state)
{
    const auto recording = readLog(campaignFile().path(), {});
    if (!recording)
        return state.SkipWithError(recording.error().message.c_str());
    const std::filesystem::path copy = campaignFile().path().string() + ".copy";
    for (auto _ : state) {
        if (Status written = writeCsv(copy, *recording); !written)
            return state.SkipWithError(written.error().message.c_str());
    }
    std::filesystem::remove(copy);
    countBytes(state);
}

} // namespace

BENCHMARK(csvToRecording)->Unit(benchmark::kMillisecond);
BENCHMARK(csvBlocks)->Unit(benchmark::kMillisecond);
BENCHMARK(csvLinesOnly)->Unit(benchmark::kMillisecond);
BENCHMARK(csvWriting)->Unit(benchmark::kMillisecond);
