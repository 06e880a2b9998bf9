// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"
#include "views/choice_box.h"

namespace cradle {

/// The language of all texts of the author's window: those of steps, checks, hints and mistakes.
/// It stands where every tab can be seen with it, for what is typed goes into that language.
class LanguageBox final : public ChoiceBox
{
    Q_OBJECT
public:
    explicit LanguageBox(AuthorDocument &document, QWidget *parent = nullptr);

private:
    void showLanguages();
    void retranslate();

    AuthorDocument &m_document;
};

} // namespace cradle
