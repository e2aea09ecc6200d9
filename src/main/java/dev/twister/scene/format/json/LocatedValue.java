package dev.twister.scene.format.json;

import java.util.List;

/** A JSON value that knows where in the text it starts, in characters from 0. */
public sealed interface LocatedValue {
    int offset();

    /** A field of an object; the offset is its name's. */
    record Member(int offset, String name, LocatedValue value) {}

    /** The members' names are distinct. */
    record ObjectValue(int offset, List<Member> members) implements LocatedValue {}

    record ArrayValue(int offset, List<LocatedValue> items) implements LocatedValue {}

    /** The nearest double; infinite where the text overflows one, and NaN where it says so. */
    record NumberValue(int offset, double number) implements LocatedValue {}

    record TextValue(int offset, String text) implements LocatedValue {}

    record FlagValue(int offset, boolean flag) implements LocatedValue {}

    record NullValue(int offset) implements LocatedValue {}
}
