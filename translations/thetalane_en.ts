<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>SceneSourceText</name>
    <message numerus="yes">
        <source>%1 (and %n more)</source>
        <translation>
            <numerusform>%1 (and %n more)</numerusform>
            <numerusform>%1 (and %n more)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>thetalane::ScrubBar</name>
    <message numerus="yes">
        <source>and %n more at the same instant</source>
        <translation>
            <numerusform>and %n more at the same instant</numerusform>
            <numerusform>and %n more at the same instant</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>thetalane::StepPanel</name>
    <message numerus="yes">
        <source>one of %n at the same instant</source>
        <translation>
            <numerusform>one of %n at the same instant</numerusform>
            <numerusform>one of %n at the same instant</numerusform>
        </translation>
    </message>
</context>
</TS>
