// Empty: a precompiled header belongs to a program or library, and this is its source.
