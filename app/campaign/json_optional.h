// A value that may be missing, in JSON: null.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace driftbench {

template <class T>
nlohmann::ordered_json orNull(const std::optional<T> &value)
{
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

// Throws where the key is missing or the value of another type, as json.at(key) does.
template <class T>
std::optional<T> optionalAt(const nlohmann::ordered_json &json, const char *key)
{
    const nlohmann::ordered_json &value = json.at(key);
    return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

} // namespace driftbench
