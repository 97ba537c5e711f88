// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial/line_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/line_box.hpp"

namespace sightline::detail {

LineCut::LineCut(const SceneForms& forms)
    : forms_(&forms),
      side_stamp_(0),
      edge_stamp_(forms.edge_count()),
      vertex_stamp_(forms.scene().vertices().size()),
      face_stamp_(forms.scene().faces().size()) {
    side_stamp_.resize(forms.line_count());
    side_sign_.resize(forms.line_count());
    for (const Body3& b : forms.scene().bodies()) {
        has_sheets_ = has_sheets_ || b.kind == SurfaceKind::sheet;
    }
}

void LineCut::cut(const Line& line, const KnownFeatures& known) {
    line_ = &line;
    find_axis();
    collect(known);
    if (!blocking_.is_none()) return;
    position_contacts();
    sort_into_places();
    find_touches();
    find_blocked();
    find_runs();
}

void LineCut::assume(const KnownFeatures& known) {
    const auto meets = [&](EdgeId e) {
        side_stamp_[e.index()] = stamp_;
        side_sign_[e.index()] = Sign::zero;
    };
    for (const VertexId v : known.vertices) {
        add_vertex(v);
        for (const EdgeId e : forms_->scene().edges_at(v)) {
            meets(e);
            if (known.is_general) edge_stamp_[e.index()] = stamp_;
        }
    }
    if (!known.also_vertex.is_none()) {
        add_vertex(known.also_vertex);
        for (const EdgeId e : forms_->scene().edges_at(known.also_vertex)) meets(e);
    }
    if (!known.also_edge.is_none()) meets(known.also_edge);
    for (const EdgeId e : known.edges) {
        meets(e);
        if (!known.is_general || edge_stamp_[e.index()] == stamp_) continue;
        edge_stamp_[e.index()] = stamp_;
        contacts_.push_back({Feature::edge, e.value, Real{}, 0});
    }
}

void LineCut::collect(const KnownFeatures& known) {
    contacts_.clear();
    collinear_.clear();
    ++stamp_;
    blocking_ = FaceId::none();
    window_low_ = -std::numeric_limits<double>::infinity();
    window_high_ = std::numeric_limits<double>::infinity();
    assume(known);
    if (known.only_their_segment && find_window(known)) {
        collect_near(known);
        return;
    }
    const LineBoxTest meets(line_->real());
    forms_->triangles().traverse(meets, [&](std::uint32_t t) { add_triangle(t); });
}

/// Where the known features lie along the line; false when the filter cannot tell.
bool LineCut::find_window(const KnownFeatures& known) {
    first_ = std::numeric_limits<double>::infinity();
    last_ = -first_;
    window_low_ = -first_;
    window_high_ = first_;
    const auto include = [&](const Real& x) {
        first_ = std::min(first_, x.lower());
        last_ = std::max(last_, x.upper());
        return std::isfinite(x.lower()) && std::isfinite(x.upper());
    };
    bool known_all = true;
    for (const VertexId v : known.vertices) {
        known_all = include(forms_->point<Real>(v)[axis_]) && known_all;
    }
    for (const EdgeId e : known.edges) {
        known_all = include(position_of({Feature::edge, e.value, Real{}, 0})) && known_all;
    }
    return known_all && first_ <= last_;
}

/// From the known features outwards, up to what surely stops the segment.
void LineCut::collect_near(const KnownFeatures& known) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const LineBoxTest meets(line_->real());
    // Strictly between these a crossing surely separates the known features.
    double inner_low = -infinite;
    double inner_high = infinite;
    const auto narrow_inner = [&](const Real& x) {
        inner_low = inner_low == -infinite ? x.upper() : std::min(inner_low, x.upper());
        inner_high = inner_high == infinite ? x.lower() : std::max(inner_high, x.lower());
    };
    for (const VertexId v : known.vertices) narrow_inner(forms_->point<Real>(v)[axis_]);
    for (const EdgeId e : known.edges) {
        narrow_inner(position_of({Feature::edge, e.value, Real{}, 0}));
    }
    const auto gap = [&](const Box3& box) {
        if (box.low[axis_] > window_high_ || box.high[axis_] < window_low_) return infinite;
        if (!meets(box)) return infinite;
        return std::max({0.0, box.low[axis_] - last_, first_ - box.high[axis_]});
    };
    forms_->triangles().traverse_ordered(gap, [&](std::uint32_t t) {
        const std::size_t before = contacts_.size();
        add_triangle(t);
        for (std::size_t i = before; i < contacts_.size(); ++i) {
            if (contacts_[i].feature != Feature::face) continue;
            const Real x = position_of(contacts_[i]);
            if (x.lower() > inner_low && x.upper() < inner_high) {
                blocking_ = FaceId{contacts_[i].id};
                return -infinite;
            }
            if (x.lower() > last_) window_high_ = std::min(window_high_, x.upper());
            if (x.upper() < first_) window_low_ = std::max(window_low_, x.lower());
        }
        return std::max(window_high_ - last_, first_ - window_low_);
    });
    // What is behind the window was found by chance, and may be half of a body.
    std::erase_if(contacts_, [&](const Contact& c) {
        const Real x = position_of(c);
        return x.lower() > window_high_ || x.upper() < window_low_;
    });
}

Sign LineCut::side_of(std::size_t i) {
    if (side_stamp_[i] == stamp_) return side_sign_[i];
    side_stamp_[i] = stamp_;
    return side_sign_[i] = line_->sign(
               Predicate::line_form3,
               [&]<typename N>(const PluckerOf<N>& l) { return side(l, forms_->line<N>(i)); });
}

void LineCut::add_triangle(std::uint32_t triangle) {
    bool has_zero = false;
    bool has_positive = false;
    bool has_negative = false;
    bool on_edge = false;
    int zeros = 0;
    for (const TriangleSide& s : forms_->sides(triangle)) {
        const Sign plain = side_of(s.line);
        const Sign sign = s.reversed ? -plain : plain;
        has_positive = has_positive || sign == Sign::positive;
        has_negative = has_negative || sign == Sign::negative;
        if (sign != Sign::zero) continue;
        has_zero = true;
        ++zeros;
        if (s.line < forms_->edge_count()) {
            on_edge = true;
            add_edge(EdgeId{s.line});
        }
    }
    if (has_positive && has_negative) return;
    // One zero at a diagonal is a point inside the face; two are a corner, three the face's plane.
    if (has_zero && (on_edge || zeros > 1)) return;
    const FaceId face = forms_->scene().triangles()[triangle].face;
    if (face_stamp_[face.index()] == stamp_) return;
    face_stamp_[face.index()] = stamp_;
    contacts_.push_back({Feature::face, face.value, Real{}, 0});
}

void LineCut::add_vertex(VertexId v) {
    if (vertex_stamp_[v.index()] == stamp_) return;
    vertex_stamp_[v.index()] = stamp_;
    contacts_.push_back({Feature::vertex, v.value, Real{}, 0});
}

void LineCut::add_edge(EdgeId e) {
    if (edge_stamp_[e.index()] == stamp_) return;
    edge_stamp_[e.index()] = stamp_;
    const Edge3& edge = forms_->scene()[e];
    // The line lies in a plane with the edge. Normals of the planes from both ends are parallel, opposite
    // when the line passes between them, zero at an end that it passes through.
    bool source_on = true;
    bool target_on = true;
    for (int axis = 0; axis < 3; ++axis) {
        const auto sign_at = [&](VertexId v) {
            return line_->sign(Predicate::line_form3, [&]<typename N>(const PluckerOf<N>& l) {
                return normal_from(l, forms_->point<N>(v), axis);
            });
        };
        const Sign at_source = sign_at(edge.source);
        const Sign at_target = sign_at(edge.target);
        if (at_source != Sign::zero && at_target != Sign::zero) {
            if (at_source != at_target) contacts_.push_back({Feature::edge, e.value, Real{}, 0});
            return;
        }
        source_on = source_on && at_source == Sign::zero;
        target_on = target_on && at_target == Sign::zero;
    }
    if (source_on) add_vertex(edge.source);
    if (target_on) add_vertex(edge.target);
    if (source_on && target_on) collinear_.push_back(e);
}

void LineCut::find_axis() {
    // The largest direction coordinate whose sign the filter knows; else the first that is not zero.
    double best = -1;
    for (int i = 0; i < 3; ++i) {
        const Real& x = line_->real().d[i];
        if (x.sign().value_or(Sign::zero) == Sign::zero || std::abs(x.value()) <= best) continue;
        best = std::abs(x.value());
        axis_ = i;
        axis_sign_ = *x.sign();
    }
    for (int i = 0; i < 3 && best < 0; ++i) {
        const Sign sign = line_->sign(Predicate::line_form3,
                                      [&]<typename N>(const PluckerOf<N>& l) { return l.d[i]; });
        if (sign == Sign::zero) continue;
        best = 0;
        axis_ = i;
        axis_sign_ = sign;
    }
}

void LineCut::position_contacts() {
    for (Contact& c : contacts_) c.position = position_of(c);
}

Real LineCut::position_of(const Contact& c) const {
    const PluckerOf<Real>& l = line_->real();
    if (c.feature == Feature::vertex) return forms_->point<Real>(VertexId{c.id})[axis_];
    if (c.feature == Feature::face) {
        const PlaneOf<Real>& plane = forms_->plane<Real>(FaceId{c.id});
        const Real across = dot(plane.n, l.d);
        return (plane.k * l.d[axis_] + cross(plane.n, l.m)[axis_]) / across;
    }
    const Edge3& edge = forms_->scene()[EdgeId{c.id}];
    const Vec3<Real>& u = forms_->point<Real>(edge.source);
    const Vec3<Real>& w = forms_->point<Real>(edge.target);
    const Vec3<Real> at_u = normal_from(l, u);
    const Vec3<Real> at_w = normal_from(l, w);
    int a = 0;
    for (int i = 1; i < 3; ++i) {
        if (std::abs(at_u[i].value() - at_w[i].value()) >
            std::abs(at_u[a].value() - at_w[a].value())) {
            a = i;
        }
    }
    const Real share = at_u[a] / (at_u[a] - at_w[a]);
    return u[axis_] + share * (w[axis_] - u[axis_]);
}

/// A plane through the contact that the line crosses; returned is the sign of n·d, as ±1.
Integer LineCut::axis_form(const Contact& c, PlaneOf<Integer>& plane) const {
    const auto crossing = [&](const Vec3<Integer>& n) {
        const ExactLine& e = line_->exact();
        const Integer a = dot(n, e.a.d);
        const Integer b = e.is_rational() ? Integer(0) : dot(n, e.b.d);
        return Integer(static_cast<int>(sign_of_surd(a, b, e.c)));
    };
    if (c.feature == Feature::face) {
        plane = forms_->plane<Integer>(FaceId{c.id});
        return crossing(plane.n);
    }
    if (c.feature == Feature::vertex) {
        plane.n = {0, 0, 0};
        plane.n[axis_] = 1;
        plane.k = forms_->point<Integer>(VertexId{c.id})[axis_];
        return static_cast<int>(axis_sign_);
    }
    const Edge3& edge = forms_->scene()[EdgeId{c.id}];
    const Vec3<Integer>& along = forms_->line<Integer>(c.id).d;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3<Integer> unit{0, 0, 0};
        unit[axis] = 1;
        plane.n = cross(along, unit);
        const Integer sign = crossing(plane.n);
        if (sgn(sign) == 0) continue;
        plane.k = dot(plane.n, forms_->point<Integer>(edge.source));
        return sign;
    }
    return 0;
}

int LineCut::order(const Contact& a, const Contact& b) const {
    const int along = static_cast<int>(axis_sign_);
    const Policy& policy = line_->policy();
    if (a.feature == Feature::vertex && b.feature == Feature::vertex) {
        return along * static_cast<int>(sign_of(a.position.value() - b.position.value()));
    }
    const Sign sign = policy.sign(Predicate::line_form3, a.position - b.position, [&] {
        PlaneOf<Integer> first;
        PlaneOf<Integer> second;
        const Integer signs = axis_form(a, first) * axis_form(b, second);
        const PluckerOf<Integer> meet = line_of(first, second);
        const ExactLine& e = line_->exact();
        const Integer x = side(e.a, meet);
        const Integer y = e.is_rational() ? Integer(0) : side(e.b, meet);
        // Positive when a comes first along the direction; undo the axis' sign, as for positions.
        return sign_of_surd(x, y, e.c) * sign_of_integer(signs) * -axis_sign_;
    });
    return along * static_cast<int>(sign);
}

void LineCut::sort_into_places() {
    // Insertion sort: few contacts, and an order that plain doubles may make inconsistent.
    for (std::size_t i = 1; i < contacts_.size(); ++i) {
        for (std::size_t j = i; j > 0 && order(contacts_[j], contacts_[j - 1]) < 0; --j) {
            std::swap(contacts_[j], contacts_[j - 1]);
        }
    }
    place_count_ = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        if (i > 0 && order(contacts_[i - 1], contacts_[i]) != 0) ++place_count_;
        contacts_[i].place = place_count_;
    }
    if (!contacts_.empty()) ++place_count_;
}

BodyId LineCut::body_of(const Contact& c) const {
    const Scene3& scene = forms_->scene();
    switch (c.feature) {
        case Feature::vertex:
            return forms_->body_of(VertexId{c.id});
        case Feature::edge:
            return scene[EdgeId{c.id}].body;
        case Feature::face:
            break;
    }
    return scene[FaceId{c.id}].body;
}

void LineCut::find_touches() {
    touches_.clear();
    for (const Contact& c : contacts_) {
        Touch touch{body_of(c), c.place, {}, {}};
        const auto states = [&](auto id) {
            touch.before = state_at(*forms_, *line_, id, Heading::backward);
            touch.after = state_at(*forms_, *line_, id, Heading::forward);
        };
        if (c.feature == Feature::vertex) states(VertexId{c.id});
        if (c.feature == Feature::edge) states(EdgeId{c.id});
        if (c.feature == Feature::face) states(FaceId{c.id});
        touches_.push_back(touch);
    }
    std::ranges::stable_sort(touches_, {}, &Touch::body);
}

void LineCut::find_blocked() {
    blocked_.assign(place_count_ + 1, false);
    blocker_.assign(place_count_ + 1, BodyId::none());
    cuts_.clear();
    for (std::size_t i = 0; i < touches_.size();) {
        std::size_t j = i;
        while (j < touches_.size() && touches_[j].body == touches_[i].body) ++j;
        const std::span<const Touch> of_body{touches_.data() + i, j - i};
        if (forms_->scene()[touches_[i].body].kind == SurfaceKind::solid) {
            follow_solid(of_body);
        } else {
            follow_sheet(of_body);
        }
        i = j;
    }
    seal();
    if (has_sheets_) judge_joint_stays();
    std::ranges::stable_sort(cuts_, {}, &SheetCut::first);
}

void LineCut::follow_solid(std::span<const Touch> touches) {
    const auto block = [&](std::uint32_t first, std::uint32_t last, BodyId body) {
        for (std::uint32_t piece = first; piece <= last; ++piece) {
            blocked_[piece] = true;
            blocker_[piece] = body;
        }
    };
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const Touch& t = touches[i];
        if (t.before.where == LocalState::Where::in) {
            const std::uint32_t from = i == 0 ? 0 : touches[i - 1].place + 1;
            block(std::min(from, t.place), t.place, t.body);
        }
        if (t.after.where == LocalState::Where::in) {
            const std::uint32_t to = i + 1 == touches.size() ? place_count_ : touches[i + 1].place;
            block(t.place + 1, std::max(to, t.place + 1), t.body);
        }
    }
    // A world that the line misses is all round it: nothing there is free.
}

void LineCut::seal() {
    seals_.clear();
    if (!forms_->scene().has_touching_bodies()) return;
    std::vector<LocalState> along;
    for (std::uint32_t piece = 1; piece < place_count_; ++piece) {
        if (blocked_[piece]) continue;
        along.clear();
        for (std::size_t i = 0; i < touches_.size(); ++i) {
            const Touch& t = touches_[i];
            if (t.place >= piece || t.after.where != LocalState::Where::on) continue;
            if (!is_last_before(i, piece) || is_sheet(t.body)) continue;
            along.push_back(t.after);
        }
        if (along.size() < 2 || !is_sealed(*forms_, *line_, along)) continue;
        blocked_[piece] = true;  // by no body alone
        for (const LocalState& state : along) {
            for (const FaceId f : state.faces) {
                if (!f.is_none()) seals_.emplace_back(piece, f);
            }
        }
    }
}

std::vector<FaceId> LineCut::seal_between(std::uint32_t first, std::uint32_t last) const {
    std::vector<FaceId> faces;
    for (const auto& [piece, face] : seals_) {
        if (first < piece && piece <= last && piece == seals_.front().first) faces.push_back(face);
    }
    return faces;
}

void LineCut::find_runs() {
    runs_.clear();
    Run run;
    bool is_open = false;
    const auto close = [&](std::uint32_t last) {
        run.last = last;
        if (is_open && (run.first == Run::none || run.last == Run::none || run.first < run.last)) {
            runs_.push_back(run);
        }
        is_open = false;
    };
    for (std::uint32_t piece = 0; piece <= place_count_; ++piece) {
        if (blocked_[piece]) {
            if (is_open) close(piece - 1);
            continue;
        }
        for (const SheetCut& c : cuts_) {
            if (c.last + 1 != piece || !is_open) continue;
            close(c.last);
            run.first = c.first;
            is_open = true;
            break;  // several sheets may be cut together
        }
        if (!is_open) {
            run.first = piece == 0 ? Run::none : piece - 1;
            is_open = true;
        }
    }
    if (is_open) close(Run::none);
}

std::uint32_t LineCut::place_of(EdgeId e) const {
    const Edge3& edge = forms_->scene()[e];
    for (const Contact& c : contacts_) {
        if (c.feature == Feature::edge && c.id == e.value) return c.place;
        if (c.feature != Feature::vertex) continue;
        if (c.id == edge.source.value || c.id == edge.target.value) return c.place;
    }
    return Run::none;
}

std::uint32_t LineCut::place_of(VertexId v) const {
    for (const Contact& c : contacts_) {
        if (c.feature == Feature::vertex && c.id == v.value) return c.place;
    }
    return Run::none;
}

BodyId LineCut::blocker_between(std::uint32_t first, std::uint32_t last) const {
    for (std::uint32_t piece = first + 1; piece <= last; ++piece) {
        if (blocked_[piece] && !blocker_[piece].is_none()) return blocker_[piece];
    }
    return BodyId::none();
}

FaceId LineCut::face_between(std::uint32_t first, std::uint32_t last) const {
    for (const Contact& c : contacts_) {
        if (c.feature == Feature::face && first < c.place && c.place < last) return FaceId{c.id};
    }
    return FaceId::none();
}

StoppingFaces LineCut::stopping_faces(const Run& run) const {
    const auto faces_at = [&](std::uint32_t place, std::uint32_t piece, Heading towards) {
        std::vector<FaceId> faces;
        for (const FaceSide& side : end_at(place, piece, towards)) {
            if (side.back) return std::vector<FaceId>{};
            faces.push_back(side.face);
        }
        return faces;
    };
    StoppingFaces faces;
    if (run.first != Run::none) faces[0] = faces_at(run.first, run.first, Heading::backward);
    if (run.last != Run::none) faces[1] = faces_at(run.last, run.last + 1, Heading::forward);
    return faces;
}

std::optional<Run> LineCut::run_through(std::uint32_t first, std::uint32_t last) const {
    for (const Run& run : runs_) {
        if (run.contains(first) && run.contains(last)) return run;
    }
    return std::nullopt;
}

namespace {
constexpr std::int64_t before_all = -1;
constexpr std::int64_t behind_all = std::numeric_limits<std::int64_t>::max();
}  // namespace

/// The place of a vertex on the line, or on which side of everything it is when it is out of the window.
std::int64_t LineCut::place_or_side(VertexId v) const {
    const std::uint32_t place = place_of(v);
    if (place != Run::none) return place;
    const bool is_high = forms_->point<Real>(v)[axis_].value() > window_high_;
    return is_high == (axis_sign_ == Sign::positive) ? behind_all : before_all;
}

void LineCut::add_support(const Run& run, Support& support) const {
    for (const Contact& c : contacts_) {
        if (!run.contains(c.place)) continue;
        if (c.feature == Feature::vertex) support.vertices.push_back(VertexId{c.id});
        if (c.feature == Feature::edge) support.edges.push_back(EdgeId{c.id});
    }
    for (const EdgeId e : collinear_) {
        const Edge3& edge = forms_->scene()[e];
        const auto [a, b] = std::minmax(place_or_side(edge.source), place_or_side(edge.target));
        const std::int64_t first = run.first == Run::none ? before_all : run.first;
        const std::int64_t last = run.last == Run::none ? behind_all : run.last;
        if (first <= a && b <= last) continue;
        if (a < last && first < b) support.along.push_back(e);
    }
    std::ranges::sort(support.vertices);
    std::ranges::sort(support.edges);
    std::ranges::sort(support.along);
}

SegmentEnd LineCut::end_at(std::uint32_t place, std::uint32_t piece, Heading towards) const {
    SegmentEnd end;
    const auto add = [&](FaceId f) {
        if (f.is_none()) return;
        bool back = false;
        if (is_sheet(forms_->scene()[f].body)) {
            const Sign sign = line_->sign(
                Predicate::line_form3,
                [&]<typename N>(const PluckerOf<N>& l) { return dot(forms_->plane<N>(f).n, l.d); });
            back = (towards == Heading::forward ? sign : -sign) == Sign::positive;
        }
        end.push_back({f, back});
    };
    for (const Contact& c : contacts_) {
        if (c.place != place) continue;
        const BodyId body = body_of(c);
        if (!stops(body, place, piece)) continue;
        if (c.feature == Feature::face) add(FaceId{c.id});
        if (c.feature == Feature::edge) {
            for (const FaceId f : forms_->scene()[EdgeId{c.id}].faces) add(f);
        }
        if (c.feature == Feature::vertex) {
            for (const FaceId f : forms_->faces_at(VertexId{c.id})) add(f);
        }
    }
    // Bodies along whose faces the blocked piece runs bound it too, without a contact at the place.
    std::vector<FaceId> contact;
    add_contact(piece, contact);
    for (const FaceId f : contact) add(f);
    std::ranges::sort(end);
    const auto repeated = std::ranges::unique(end);
    end.erase(repeated.begin(), repeated.end());
    return end;
}

void LineCut::add_contact(std::uint32_t piece, std::vector<FaceId>& faces) const {
    for (std::size_t i = 0; blocked_[piece] && i < touches_.size(); ++i) {
        const Touch& t = touches_[i];
        if (t.place >= piece || t.after.where != LocalState::Where::on) continue;
        if (!is_last_before(i, piece) || is_sheet(t.body)) continue;
        for (const FaceId f : t.after.faces) {
            if (!f.is_none()) faces.push_back(f);
        }
    }
}

std::vector<FaceId> LineCut::contact_faces(const Run& run) const {
    std::vector<FaceId> faces;
    if (run.first != Run::none) add_contact(run.first, faces);
    if (run.last != Run::none) add_contact(run.last + 1, faces);
    std::ranges::sort(faces);
    const auto repeated = std::ranges::unique(faces);
    faces.erase(repeated.begin(), repeated.end());
    return faces;
}

bool LineCut::runs_along(EdgeId e, std::uint32_t place) const {
    if (std::ranges::find(collinear_, e) == collinear_.end()) return false;
    const Edge3& edge = forms_->scene()[e];
    const std::uint32_t a = place_of(edge.source);
    const std::uint32_t b = place_of(edge.target);
    return std::min(a, b) < place && place < std::max(a, b);
}

// Whether touch i, before the piece, is the last one of its body there, which tells how it goes on.
bool LineCut::is_last_before(std::size_t i, std::uint32_t piece) const {
    return i + 1 == touches_.size() || touches_[i + 1].body != touches_[i].body ||
           touches_[i + 1].place >= piece;
}

bool LineCut::stops(BodyId body, std::uint32_t place, std::uint32_t piece) const {
    const bool is_cut = std::ranges::any_of(cuts_, [&](const SheetCut& c) {
        return c.sheet == body && (piece == place ? c.first : c.last) == place;
    });
    if (is_sheet(body)) return !blocked_[piece] && is_cut;
    if (!blocked_[piece]) return false;
    return std::ranges::any_of(touches_, [&](const Touch& t) {
        if (t.body != body || t.place != place) return false;
        const auto& state = piece == place ? t.before : t.after;
        return state.where == LocalState::Where::in || state.where == LocalState::Where::on;
    });
}

SegmentLabel LineCut::label(const Run& run) const {
    SegmentLabel label;
    add_support(run, label.support);
    if (run.first != Run::none) label.ends[0] = end_at(run.first, run.first, Heading::backward);
    if (run.last != Run::none) label.ends[1] = end_at(run.last, run.last + 1, Heading::forward);
    if (label.ends[1] < label.ends[0]) std::swap(label.ends[0], label.ends[1]);
    return label;
}

}  // namespace sightline::detail
