// What thetalane study can do, a file each.
#pragma once

#include "core/study/study.h"
#include "ui/words/language.h"

#include <QString>

#include <variant>

namespace thetalane {

int studyOfExtremes(bool quick, const QString& csvPath);

struct MethodsCall {
    StudyCases cases;
    QString title; // what is studied
    QString call;  // how to repeat it: "thetalane study throws --throws 4000"
    bool throws = false;
    quint64 seed = 0;
    StudyOptions options;
    bool models = true; // and what each model costs and changes
    QString csv;        // the file, or empty
    QString picture;
    Language::Code language = Language::Code::English;
};

// What to draw when the application that computes is gone.
struct StudyPicture {
    StudyResult result;
    QString title;
    bool throws = false;
    QString output;
    Language::Code language = Language::Code::English;
};

// Prints the table, writes the file; the status to leave with, or what to draw.
std::variant<int, StudyPicture> studyOfMethods(const MethodsCall& call);

// Prints the table of a study's CSV in Markdown.
int studyTable(const QString& csvPath);

// Makes an application of its own; no other one exists.
int drawStudyPicture(int& argc, char** argv, const StudyPicture& picture);

} // namespace thetalane
