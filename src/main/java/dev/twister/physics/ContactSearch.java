package dev.twister.physics;

/** Broad phase: finds all possible contacts until the next search, column by column, and carries the impulses over. */
final class ContactSearch {
    /** Largest number of bodies that are compared with all others; in a small scene these are all bodies. */
    private static final int MAX_GIANTS = 32;

    private static final int BODIES_AT_ONCE = 4096;

    /**
     * Limit of the pairs that are searched per body with later bodies. About a dozen touch it; only where hundreds of
     * bodies overlap are there more, and their number would grow quadratically.
     */
    private static final int MOST_SEEN = 4096;

    /** Limits of the pairs that are kept per body: the largest one for few bodies, the smallest for very many. */
    private static final int MOST_KEPT = 64;

    private static final int FEWEST_KEPT = 16;
    /** Limit of the mesh triangles, the nearest ones, that hold a body. */
    private static final int MOST_TRIANGLES = 64;

    private static final int ROOM = 1 << 22;

    private final BodyStore bodies;
    private final Surroundings surroundings;
    private final Team team;
    private final int firstBody;
    private final NeighborGrid grid;
    private final Columns columns = new Columns();
    private int[] ends = {};
    private boolean unbalanced;
    private ContactBook contacts;
    private ContactBook earlier;

    ContactSearch(BodyStore bodies, Surroundings surroundings, Team team, int firstBody, double typicalReach) {
        this.bodies = bodies;
        this.surroundings = surroundings;
        this.team = team;
        this.firstBody = firstBody;
        grid = new NeighborGrid(bodies, typicalReach);
        contacts = new ContactBook(bodies.state.length);
        earlier = new ContactBook(bodies.state.length);
    }

    Columns columns() {
        return columns;
    }

    /** Number of contact lists: one per row of columns, and a last one for the giants. */
    int lists() {
        return columns.rows() + 1;
    }

    /** The contacts of a row of columns, column after column. */
    Contacts contacts(int row) {
        return contacts.list(row);
    }

    /** End of a column's contacts in its row's list, where the next column's begin. */
    int end(int column) {
        return ends[column];
    }

    /** The contacts of the few very large or fast bodies, which are in no other list. */
    Contacts giantsContacts() {
        return contacts.list(columns.rows());
    }

    void scaleImpulses(double factor) {
        contacts.scale(factor);
    }

    /**
     * Finds all pairs of bodies whose reaches overlap.
     *
     * @param bounds bounds of the centers: minimum and maximum of x, y and z
     * @param anyJustWoken whether to list the unbalanced contacts
     */
    void search(double[] bounds, boolean anyJustWoken) {
        unbalanced = anyJustWoken;
        grid.layOut(bounds);
        team.inChunks(firstBody, bodies.count, BODIES_AT_ONCE, (from, to) -> {
            for (int body = from; body < to; body++) {
                grid.locate(body);
            }
        });
        grid.sort(firstBody, MAX_GIANTS);
        team.inChunks(0, grid.slots, BODIES_AT_ONCE, grid::gather);
        columns.sort(grid, bounds[0], bounds[1], bounds[4], bounds[5]);
        ContactBook spare = earlier;
        earlier = contacts;
        contacts = spare;
        contacts.open(columns.rows() + 1);
        if (ends.length < columns.count()) {
            ends = new int[columns.count()];
        }
        for (int color = 0; color < Columns.COLORS; color++) {
            int own = color;
            int rows = columns.rows(color);
            // One more task for the giants' pairs.
            team.each(color == 0 ? rows + 1 : rows, index -> {
                if (index < rows) {
                    searchRow(columns.row(own, index));
                } else {
                    searchGiants();
                }
            });
        }
    }

    /** Makes the bodies of a column contiguous in memory; called after a search. */
    void reorder() {
        int[] order = new int[bodies.count];
        int place = bodies.firstSphere;
        for (int column = 0; column < columns.count(); column++) {
            for (int index = columns.start(column); index < columns.end(column); index++) {
                place = put(order, place, grid.body[columns.slot(index)]);
            }
        }
        for (int slot = 0; slot < grid.slots; slot++) {
            if (grid.isGiant(slot)) {
                place = put(order, place, grid.body[slot]);
            }
        }
        int[] places = new int[bodies.count];
        for (int body = 0; body < order.length; body++) {
            places[order[body]] = body;
        }
        bodies.reorder(order);
        contacts.reorder(order, places, bodies.count);
    }

    private int put(int[] order, int place, int body) {
        if (bodies.isLight(body)) {
            return place;
        }
        order[place] = body;
        return place + 1;
    }

    private void searchRow(int row) {
        Contacts list = contacts.list(row);
        int first = columns.firstOfRow(row);
        for (int column = first; column < first + columns.columnsInRow(); column++) {
            for (int index = columns.start(column); index < columns.end(column); index++) {
                int slot = columns.slot(index);
                int start = list.count;
                list.limit(MOST_SEEN);
                grid.addPairs(slot, list);
                thin(grid.body[slot], list, start);
                finish(grid.body[slot], row, start);
            }
            ends[column] = list.count;
        }
    }

    private void thin(int body, Contacts list, int start) {
        int most = Math.clamp(ROOM / bodies.count, FEWEST_KEPT, MOST_KEPT);
        if (list.count - start > most) {
            list.keepLeast(start, most, other -> nearness(body, other));
        }
    }

    /** The squared distance of two bodies' centers, relative to the squared sum of their radii. */
    private double nearness(int one, int other) {
        double[] n = bodies.numbers;
        int a = BodyStore.STRIDE * one;
        int b = BodyStore.STRIDE * other;
        double dx = n[a] - n[b];
        double dy = n[a + 1] - n[b + 1];
        double dz = n[a + 2] - n[b + 2];
        double radii = n[a + BodyStore.RADIUS] + n[b + BodyStore.RADIUS];
        return (dx * dx + dy * dy + dz * dz) / (radii * radii);
    }

    private void searchGiants() {
        Contacts list = giantsContacts();
        list.unlimited();
        for (int slot = 0; slot < grid.slots; slot++) {
            if (grid.isGiant(slot)) {
                int start = list.count;
                grid.addGiantsPairs(slot, list);
                finish(grid.body[slot], columns.rows(), start);
            }
        }
    }

    private void finish(int body, int list, int start) {
        if (bodies.state[body] != BodyStore.ASLEEP) {
            addSurfaces(body, contacts.list(list));
        }
        contacts.list(list).setFirst(body, start);
        contacts.setRange(body, list, start);
        contacts.inherit(earlier, body);
        if (unbalanced) {
            findUnbalanced(body, contacts.list(list), start);
        }
    }

    private void findUnbalanced(int body, Contacts list, int start) {
        boolean woken = bodies.isJustWoken(body);
        for (int contact = start; contact < list.count; contact++) {
            int other = list.second[contact];
            if (woken || (other >= 0 && bodies.isJustWoken(other))) {
                list.addUnbalanced(contact);
            }
        }
    }

    private void addSurfaces(int body, Contacts list) {
        int at = BodyStore.STRIDE * body;
        double x = bodies.numbers[at + BodyStore.POSITION];
        double y = bodies.numbers[at + BodyStore.POSITION + 1] - surroundings.height();
        double z = bodies.numbers[at + BodyStore.POSITION + 2];
        double reach = bodies.reach[body];
        if (surroundings.isOver(x, z)) {
            if (bodies.side[body] * y <= reach) {
                list.add(-1 - Surroundings.GROUND);
            }
        } else {
            double outX = x - surroundings.nearest(x);
            double outZ = z - surroundings.nearest(z);
            if (outX * outX + y * y + outZ * outZ <= reach * reach) {
                list.add(-1 - Surroundings.GROUND);
            }
            bodies.side[body] = (byte) (y >= 0 ? 1 : -1);
        }
        if (bodies.walled[body]) {
            for (int wall = 0; wall < Surroundings.WALLS; wall++) {
                if (surroundings.halfSide() - surroundings.towardsWall(wall, x, z) <= reach) {
                    list.add(-1 - Surroundings.FIRST_WALL - wall);
                }
            }
        }
        if (surroundings.mesh().triangles() > 0) {
            addTriangles(body, list);
        }
    }

    private void addTriangles(int body, Contacts list) {
        MeshCollider mesh = surroundings.mesh();
        double[] n = bodies.numbers;
        int at = BodyStore.STRIDE * body;
        int start = list.count;
        double reach = bodies.reach[body] + mesh.reach();
        mesh.near(n[at], n[at + 1], n[at + 2], reach, triangle -> {
            TriangleContact contact = mesh.contact(triangle);
            contact.meet(n[at], n[at + 1], n[at + 2], 0, 0, 0, 0);
            if (contact.away() <= reach) {
                list.add(triangle);
            }
        });
        if (list.count - start > MOST_TRIANGLES) {
            list.keepLeast(start, MOST_TRIANGLES, triangle -> {
                TriangleContact contact = mesh.contact(triangle);
                contact.meet(n[at], n[at + 1], n[at + 2], 0, 0, 0, 0);
                return contact.away();
            });
        }
        for (int contact = start; contact < list.count; contact++) {
            int triangle = list.second[contact];
            int first = -1 - Surroundings.FIRST_TRIANGLE - 2 * triangle;
            list.second[contact] = first - side(body, triangle, first);
        }
    }

    /** The side of a triangle that a body is on; a body that is pressed into it stays on its former side. */
    private int side(int body, int triangle, int first) {
        double[] n = bodies.numbers;
        int at = BodyStore.STRIDE * body;
        TriangleContact contact = surroundings.mesh().contact(triangle);
        int side = contact.height(n[at], n[at + 1], n[at + 2]) >= 0 ? 0 : 1;
        contact.meet(n[at], n[at + 1], n[at + 2], side, 0, 0, 0);
        boolean pressed = contact.isOver()
                && contact.distance < n[at + BodyStore.RADIUS]
                && earlier.isLoaded(body, first - (1 - side));
        return pressed ? 1 - side : side;
    }
}
