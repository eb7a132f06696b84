// Options about logs and runs that several commands have, with the same words.
#pragma once

#include "app/campaign/campaign_request.h"

#include <CLI/CLI.hpp>
#include <string>

namespace driftbench::cli {

// --instance, --columns, --separator, --time-unit, --rate-unit, --sensitivity, --temperature-unit
void addReadOptions(CLI::App &command, ReadOptions &read);

// --sensor MODEL:SERIAL
void addSensorOption(CLI::App &command, SensorIdentity &sensor);

// --exclude, --mask-bad-rows, --force-span
void addQualityOptions(CLI::App &command, QualityOptions &quality);

// RUN..., and all of the above with --reference-rate X,Y,Z|hold
void addCampaignOptions(CLI::App &command, CampaignRequest &request);

// Warnings about the runs, once each, on standard error.
void printFindings(const Campaign &campaign);
void printWarnings(const std::string &about, const std::vector<std::string> &warnings);

} // namespace driftbench::cli
