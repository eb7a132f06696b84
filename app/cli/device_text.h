// What the `device` commands print, for people and for machines.
#pragma once

#include "device/bridge/bridge_codec.h"
#include "device/hid_transport.h"
#include "device/table_upload.h"
#include "engine/exports/device_image.h"

#include <nlohmann/json.hpp>
#include <string>

namespace driftbench::cli {

struct DeviceFacts
{
    HidIdentity identity;
    BridgeInfo info;
    BridgeConfig config;
    BridgeStatus status;
};

std::string factsAsText(const DeviceFacts &facts);
nlohmann::ordered_json factsAsJson(const DeviceFacts &facts);

std::string banksAsText(const BridgeStatus &status);
nlohmann::ordered_json banksAsJson(const BridgeStatus &status);

// How the device's compensation compares with the host's, in a sentence; empty: not in use, so not compared.
std::string checkText(const TableUploadReport &upload);

std::string uploadAsText(const TableUploadReport &upload);
nlohmann::ordered_json uploadAsJson(const TableUploadReport &upload);

std::string imageAsText(const DeviceImage &image);

} // namespace driftbench::cli
