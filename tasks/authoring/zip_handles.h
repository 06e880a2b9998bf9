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

using ZipArchive = std::unique_ptr<zip_t, DiscardZip>;
using ZipFile = std::unique_ptr<zip_file_t, CloseZipFile>;
using ZipSource = std::unique_ptr<zip_source_t, FreeZipSource>;

} // namespace cradle
