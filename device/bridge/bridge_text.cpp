#include "device/bridge/bridge_codec.h"

namespace driftbench {

std::string bridgeCommandText(std::uint8_t reportId)
{
    switch (reportId) {
    case BRIDGE_REPORT_CONFIG:
        return "take the configuration";
    case BRIDGE_REPORT_BEGIN:
        return "begin a table";
    case BRIDGE_REPORT_CHUNK:
        return "take bytes of the table";
    case BRIDGE_REPORT_READ:
        return "read a table back";
    case BRIDGE_REPORT_VERIFY:
        return "verify the table";
    case BRIDGE_REPORT_COMMIT:
        return "commit the table";
    case BRIDGE_REPORT_ACTIVATE:
        return "activate the table";
    case BRIDGE_REPORT_ROLLBACK:
        return "roll the table back";
    default:
        return "take report " + std::to_string(reportId);
    }
}

std::string bridgeResultText(std::uint8_t result)
{
    switch (result) {
    case BRIDGE_RESULT_OK:
        return "done";
    case BRIDGE_RESULT_UNKNOWN_COMMAND:
        return "its firmware does not know this command; update the firmware";
    case BRIDGE_RESULT_BAD_LENGTH:
        return "the length can't be; a table must not be longer than the device's info allows";
    case BRIDGE_RESULT_BAD_VALUE:
        return "a value lies outside its range; see the limits in the device's info";
    case BRIDGE_RESULT_NO_UPLOAD:
        return "no upload is running, it may have been reset; upload again from the start";
    case BRIDGE_RESULT_WRONG_UPLOAD:
        return "another program uploads a table; close that one first";
    case BRIDGE_RESULT_WRONG_OFFSET:
        return "the bytes do not follow those that it has; upload again from the start";
    case BRIDGE_RESULT_INCOMPLETE:
        return "bytes of the table are missing; upload again from the start";
    case BRIDGE_RESULT_BAD_CRC:
        return "the bytes in its flash are not those that were announced; upload again, and if that fails "
               "too, the flash is worn";
    case BRIDGE_RESULT_BAD_TABLE:
        return "the table contradicts itself or is of a kind that it can't use; make one of a kind that the "
               "device's info names";
    case BRIDGE_RESULT_OTHER_SENSOR:
        return "the table is for another sensor; use the one that was made for this model and serial number";
    case BRIDGE_RESULT_NOT_VERIFIED:
        return "the table has not been verified; verify it first";
    case BRIDGE_RESULT_NOTHING_THERE:
        return "there is no such table; upload one first";
    case BRIDGE_RESULT_FLASH:
        return "its flash refused; try again, and if that fails too, the flash is worn";
    case BRIDGE_RESULT_BUSY:
        return "it is streaming; stop that first";
    case BRIDGE_RESULT_FULL:
        return "there is no room left for another mark; upload the table anew";
    default:
        return "it gave the unknown reason " + std::to_string(result) + "; update this program";
    }
}

std::string bridgeBankStateText(std::uint8_t state)
{
    switch (state) {
    case BRIDGE_BANK_EMPTY:
        return "empty";
    case BRIDGE_BANK_COMMITTED:
        return "committed";
    case BRIDGE_BANK_ACTIVATED:
        return "activated";
    case BRIDGE_BANK_REVOKED:
        return "revoked";
    case BRIDGE_BANK_FOREIGN:
        return "of another sensor";
    default:
        return "unknown state " + std::to_string(state);
    }
}

} // namespace driftbench
