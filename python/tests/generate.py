"""Makes the modules of the package that follow from the library."""

from __future__ import annotations

import generate_records
import generate_sections
import generate_tasks

#: What makes each of them.
SOURCES = {
    generate_tasks.FILE: generate_tasks.source,
    generate_sections.PACKAGE / "sections.py": generate_sections.sections,
    generate_records.FILE: generate_records.records,
    generate_sections.PACKAGE / "_presets.py": generate_sections.presets,
}

if __name__ == "__main__":
    for file, source in SOURCES.items():
        file.write_text(source(), encoding="utf-8")
