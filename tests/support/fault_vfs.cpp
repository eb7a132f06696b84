#include "support/fault_vfs.h"

#include <atomic>
#include <cstring>
#include <mutex>
#include <sqlite3.h>
#include <string_view>

namespace driftbench::test {

namespace {

struct Plan
{
    std::mutex mutex;
    Fault fault = Fault::None;
    std::int64_t left = 0;
    bool lasting = false;
    bool happened = false;
    std::string under;
};
Plan plan;

enum class Operation
{
    Write,
    Sync,
    Truncate,
};

bool concerns(Fault fault, Operation operation)
{
    switch (fault) {
    case Fault::None:
        return false;
    case Fault::SyncError:
        return operation == Operation::Sync;
    case Fault::AnyError:
        return true;
    default:
        return operation == Operation::Write;
    }
}

Fault due(Operation operation, const char *name)
{
    const std::lock_guard guard(plan.mutex);
    if (!concerns(plan.fault, operation))
        return Fault::None;
    if (!plan.under.empty() && (name == nullptr || !std::string_view(name).starts_with(plan.under)))
        return Fault::None;
    if (plan.left > 0)
        --plan.left;
    if (plan.left > 0 || (plan.happened && !plan.lasting))
        return Fault::None;
    plan.happened = true;
    return plan.fault;
}

sqlite3_vfs *systemVfs()
{
    static sqlite3_vfs *const vfs = sqlite3_vfs_find(nullptr);
    return vfs;
}

struct FaultFile
{
    sqlite3_file base;
    const char *name; // SQLite keeps it as long as the file is open; null: a temporary one
};

const char *nameOf(sqlite3_file *file)
{
    return reinterpret_cast<FaultFile *>(file)->name;
}

sqlite3_file *real(sqlite3_file *file)
{
    return reinterpret_cast<sqlite3_file *>(reinterpret_cast<FaultFile *>(file) + 1);
}

int onWrite(sqlite3_file *file, const void *bytes, int count, sqlite3_int64 offset)
{
    const auto write = real(file)->pMethods->xWrite;
    switch (due(Operation::Write, nameOf(file))) {
    case Fault::None:
        return write(real(file), bytes, count, offset);
    case Fault::DiskFull:
        return SQLITE_FULL;
    case Fault::TornWrite:
        write(real(file), bytes, count / 2, offset);
        return SQLITE_IOERR_WRITE;
    default:
        return SQLITE_IOERR_WRITE;
    }
}

int onSync(sqlite3_file *file, int flags)
{
    return due(Operation::Sync, nameOf(file)) == Fault::None ? real(file)->pMethods->xSync(real(file), flags)
                                                             : SQLITE_IOERR_FSYNC;
}

int onTruncate(sqlite3_file *file, sqlite3_int64 size)
{
    return due(Operation::Truncate, nameOf(file)) == Fault::None
               ? real(file)->pMethods->xTruncate(real(file), size)
               : SQLITE_IOERR_TRUNCATE;
}

const sqlite3_io_methods kMethods{
    2,
    [](sqlite3_file *f) { return real(f)->pMethods->xClose(real(f)); },
    [](sqlite3_file *f, void *to, int n, sqlite3_int64 at) {
        return real(f)->pMethods->xRead(real(f), to, n, at);
    },
    onWrite,
    onTruncate,
    onSync,
    [](sqlite3_file *f, sqlite3_int64 *size) { return real(f)->pMethods->xFileSize(real(f), size); },
    [](sqlite3_file *f, int level) { return real(f)->pMethods->xLock(real(f), level); },
    [](sqlite3_file *f, int level) { return real(f)->pMethods->xUnlock(real(f), level); },
    [](sqlite3_file *f, int *out) { return real(f)->pMethods->xCheckReservedLock(real(f), out); },
    [](sqlite3_file *f, int op, void *arg) { return real(f)->pMethods->xFileControl(real(f), op, arg); },
    [](sqlite3_file *f) { return real(f)->pMethods->xSectorSize(real(f)); },
    [](sqlite3_file *f) { return real(f)->pMethods->xDeviceCharacteristics(real(f)); },
    [](sqlite3_file *f, int page, int size, int extend, void volatile **out) {
        return real(f)->pMethods->xShmMap(real(f), page, size, extend, out);
    },
    [](sqlite3_file *f, int offset, int n, int flags) {
        return real(f)->pMethods->xShmLock(real(f), offset, n, flags);
    },
    [](sqlite3_file *f) { real(f)->pMethods->xShmBarrier(real(f)); },
    [](sqlite3_file *f, int remove) { return real(f)->pMethods->xShmUnmap(real(f), remove); },
    nullptr,
    nullptr,
};

int onOpen(sqlite3_vfs *, const char *name, sqlite3_file *file, int flags, int *out)
{
    file->pMethods = nullptr;
    reinterpret_cast<FaultFile *>(file)->name = name;
    real(file)->pMethods = nullptr;
    const int code = systemVfs()->xOpen(systemVfs(), name, real(file), flags, out);
    if (real(file)->pMethods != nullptr)
        file->pMethods = &kMethods;
    return code;
}

} // namespace

void registerFaultVfs(bool asDefault)
{
    static sqlite3_vfs vfs = [] {
        sqlite3_vfs copy = *systemVfs();
        copy.zName = kFaultVfs;
        copy.szOsFile += static_cast<int>(sizeof(FaultFile));
        copy.xOpen = onOpen;
        return copy;
    }();
    sqlite3_vfs_register(&vfs, asDefault ? 1 : 0);
}

void injectFault(Fault fault, std::int64_t at, bool lasting, const std::string &under)
{
    const std::lock_guard guard(plan.mutex);
    plan.under = under;
    plan.fault = fault;
    plan.left = at;
    plan.lasting = lasting;
    plan.happened = false;
}

void clearFaults()
{
    const std::lock_guard guard(plan.mutex);
    plan.fault = Fault::None;
}

bool faultHappened()
{
    const std::lock_guard guard(plan.mutex);
    return plan.happened;
}

} // namespace driftbench::test
