// Nothing: a precompiled header is made for a program or library, and this is its source.
