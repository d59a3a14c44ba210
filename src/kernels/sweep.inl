// The best value over a round or square element, two rows at a time, in one sweep that keeps all between in registers.
//
// The including file defines, beside what loops.inl wants: earlier<K>(before, now) and later<K>(now, after), the
// columns K to the left and to the right of `now`, where `before` and `after` are its neighbours.

template <int kHalf>
struct Round {
  static constexpr SweepRecipe kRecipe = round_recipe(kHalf);
};
template <int kHalf>
struct Square {
  static constexpr SweepRecipe kRecipe = square_recipe(kHalf);
};

template <class Order, class Element>
struct ElementSweep {
  static constexpr SweepRecipe kRecipe = Element::kRecipe;
  static constexpr int kSteps = kRecipe.step_count;
  static constexpr int kCores = kRecipe.lag[kRecipe.rectangle_count - 1];

  struct Pair {
    Bytes upper;
    Bytes lower;
  };

  // A step looks one vector ahead, so it works one vector behind the step before it; and the rows of a rectangle are
  // taken in where the step that joins it has arrived.
  Pair before[kSteps];
  Pair now[kSteps];
  Bytes core[kCores + 1];  ///< rows that the windows of both middles have in common, on their way to the next rectangle
  Bytes grown_core;

  static Bytes row(const SweepPlace& place, int i) { return load(place.pair->rows[i] + place.x); }

  // The window of rectangle j's rows. Rows of smaller rectangles come as a core, of which lag[j] - lag[j - 1] are on
  // the way.
  template <int j>
  inline Pair window(const SweepPlace* places) {
    const SweepPlace& place = places[-kRecipe.lag[j]];
    Bytes common;
    int dv = 1;
    if constexpr (j == 0) {
      common = Order::of(row(place, 0), row(place, 1));
    } else {
      constexpr int kFirst = kRecipe.lag[j - 1];
      constexpr int kLast = kRecipe.lag[j] - 1;
      common = core[kLast];
      pass_on<kFirst, kLast>();
      core[kFirst] = grown_core;
      dv = kRecipe.reach_v[j - 1] + 1;
    }
    for (; dv < kRecipe.reach_v[j]; ++dv) {
      common = Order::of(common, Order::of(row(place, 2 * dv), row(place, 2 * dv + 1)));
    }
    if constexpr (kRecipe.reach_v[j] == 0) {
      grown_core = common;
      return {row(place, 0), row(place, 1)};
    }
    const Bytes below = row(place, 2 * kRecipe.reach_v[j] + 1);
    const Bytes upper = Order::of(common, row(place, 2 * kRecipe.reach_v[j]));
    grown_core = Order::of(upper, below);
    return {upper, Order::of(common, below)};
  }

  template <int kFirst, int kLast>
  inline void pass_on() {
    if constexpr (kLast > kFirst) {
      core[kLast] = core[kLast - 1];
      pass_on<kFirst, kLast - 1>();
    }
  }

  template <int k>
  static inline Bytes widened(Bytes before_it, Bytes it, Bytes after_it) {
    constexpr int kShift = kRecipe.steps[k].shift;
    const Bytes ends = Order::of(earlier<kShift>(before_it, it), later<kShift>(it, after_it));
    if constexpr (kRecipe.steps[k].centre) return Order::of(ends, it);
    return ends;
  }

  template <int k>
  inline void step(const SweepPlace* places, Pair& best) {
    const Pair middle = now[k];
    Pair next = {widened<k>(before[k].upper, middle.upper, best.upper),
                 widened<k>(before[k].lower, middle.lower, best.lower)};
    before[k] = middle;
    now[k] = best;
    if constexpr (kRecipe.steps[k].joins >= 0) {
      const Pair joined = window<kRecipe.steps[k].joins>(places);
      next = {Order::of(next.upper, joined.upper), Order::of(next.lower, joined.lower)};
    }
    best = next;
  }

  template <int... k>
  inline void sweep(const SweepPlace* places, int count, std::integer_sequence<int, k...>) {
    for (const SweepPlace* place = places; place < places + count; ++place) {
      Pair best = window<0>(place);
      (step<k>(place, best), ...);
      const SweepPlace& done = place[-kSteps];
      store(done.pair->upper + done.x, best.upper);
      store(done.pair->lower + done.x, best.lower);
    }
  }

  static void run(std::uint8_t* state, const SweepPlace* places, int count) {
    static_assert(sizeof(ElementSweep) <= kSweepStateBytes);
    // A copy: what has its address taken does not stay in registers.
    ElementSweep* kept = reinterpret_cast<ElementSweep*>(state);
    ElementSweep local = *kept;
    local.sweep(places, count, std::make_integer_sequence<int, kSteps>{});
    *kept = local;
  }
};

template <class Order, template <int> class Element, int... kHalf>
constexpr SweepLoops sweep_loops(std::integer_sequence<int, kHalf...>) {
  return {{ElementSweep<Order, Element<kHalf + 1>>::run...}};
}
