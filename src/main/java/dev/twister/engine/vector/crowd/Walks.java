package dev.twister.engine.vector.crowd;

/** One thread's tools for walks through the hierarchy. */
public final class Walks {
    /** All of a tile's rays, one packet, or one ray of it, on the way through the hierarchy. */
    public final Beam beam = new Beam();

    /** One ray, or lines to the light, for each lane. */
    public final PacketBeams packetBeams = new PacketBeams();

    public final Leaves leaves = new Leaves();
    public final PacketLeaves packetLeaves = new PacketLeaves();
    public final Descent descent = new Descent();
    final RaySpheres raySpheres = new RaySpheres();
    final Entrance entrance = new Entrance();

    /** The leaf that a ray on its way down has come to, with the ray's number above. */
    final int[] leafMet = new int[1];
}
