// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zip.h>

#include <memory>

namespace cradle {

// Owners of what libzip gives out. An archive that is not closed is thrown away.

struct DiscardZip {
    void operator()(zip_t *archive) const { zip_discard(archive); }
};
struct CloseZipFile {
    void operator()(zip_file_t *file) const { zip_fclose(file); }
};
struct FreeZipSource {
    void operator()(zip_source_t *source) const { zip_source_free(source); }
};

/// Why libzip refused; it keeps the text that it makes of it.
class ZipError
{
public:
    ZipError() { zip_error_init(&m_error); }
    ~ZipError() { zip_error_fini(&m_error); }
    ZipError(const ZipError &) = delete;
    ZipError &operator=(const ZipError &) = delete;

    operator zip_error_t *() { return &m_error; }
    [[nodiscard]] const char *text() { return zip_error_strerror(&m_error); }

private:
    zip_error_t m_error{};
};

using ZipArchive = std::unique_ptr<zip_t, DiscardZip>;
using ZipFile = std::unique_ptr<zip_file_t, CloseZipFile>;
using ZipSource = std::unique_ptr<zip_source_t, FreeZipSource>;

} // namespace cradle
