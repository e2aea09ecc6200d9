package dev.twister.mesh.assembly;

/** Hashing for open-addressing tables. */
public final class TableHash {
    private TableHash() {}

    public static int of(int a, int b, int c) {
        long mixed = a * 0x9e3779b97f4a7c15L ^ b * 0xbf58476d1ce4e5b9L ^ c * 0x94d049bb133111ebL;
        mixed = (mixed ^ mixed >>> 32) * 0xd6e8feb86659fd93L;
        return (int) (mixed >>> 32);
    }

    /** A power of two, at least twice the number of entries as far as the length of an array allows. */
    static int tableSize(int entries) {
        return 1 << Math.min(30, 33 - Integer.numberOfLeadingZeros(Math.max(1, entries) - 1));
    }
}
