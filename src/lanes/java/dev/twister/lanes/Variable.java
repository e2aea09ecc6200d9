package dev.twister.lanes;

/** A value per lane. It is a Java variable within a unit; what several units use has a column in memory. */
final class Variable {
    /** No column. */
    static final int NONE = -1;

    final Kind kind;

    /** Whether it is set more than once. */
    final boolean isMutable;

    private final int number;

    /** Whether its column is one that callers know. */
    boolean isPinned;

    boolean hasColumn;
    int column = NONE;

    /** Numbers of the first and the last statement that use it, once these are counted. */
    int first = NONE;

    int last = NONE;

    Variable(int number, Kind kind, boolean isMutable) {
        this.number = number;
        this.kind = kind;
        this.isMutable = isMutable;
    }

    /** Gives it a column that callers know. */
    Variable pinnedAt(int place) {
        isPinned = true;
        hasColumn = true;
        column = place;
        return this;
    }

    @Override
    public String toString() {
        return kind.letter + number;
    }
}
