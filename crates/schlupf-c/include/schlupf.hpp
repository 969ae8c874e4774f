/* schlupf: the force element in C++11. */

#ifndef SCHLUPF_HPP
#define SCHLUPF_HPP

#include <schlupf.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace schlupf {

/** A case that is wrong, or an element that cannot be made; what() is its message. */
class Error : public std::runtime_error {
public:
    Error(SchlupfStatus status, const std::string &message)
        : std::runtime_error(message), status(status) {}
    SchlupfStatus status;
};

/** What an input, output or state is. */
struct Quantity {
    std::string name, unit, description;
};

/** Outputs, rates and derivatives, a row of derivatives for each of the former. */
struct Evaluation {
    std::vector<double> outputs, rates, derivatives;
    std::size_t columns;

    double derivative(std::size_t of, std::size_t by) const {
        return derivatives[of * columns + by];
    }
};

/** A force element, destroyed with this object. */
class Element {
public:
    /** From the text of a case; `folder` is where its files are. */
    static Element from_text(const std::string &text, const std::vector<std::string> &overrides = {},
                             const std::string &folder = "") {
        Element made;
        made.check(schlupf_element_from_text(text.c_str(), folder.c_str(), pointers(overrides).data(),
                                             overrides.size(), &made.element_));
        return made;
    }

    /** From a case file. */
    static Element from_file(const std::string &path,
                             const std::vector<std::string> &overrides = {}) {
        Element made;
        made.check(schlupf_element_from_file(path.c_str(), pointers(overrides).data(),
                                             overrides.size(), &made.element_));
        return made;
    }

    Element(Element &&other) noexcept : element_(other.element_) { other.element_ = 0; }
    Element &operator=(Element &&other) noexcept {
        std::swap(element_, other.element_);
        return *this;
    }
    ~Element() { schlupf_element_destroy(element_); }

    Element clone() const {
        Element copy;
        copy.check(schlupf_element_clone(element_, &copy.element_));
        return copy;
    }

    /** The number for functions of schlupf.h. */
    SchlupfElement get() const { return element_; }

    /** How many SCHLUPF_INPUTS, SCHLUPF_OUTPUTS or SCHLUPF_STATES there are, and what. */
    std::size_t count(int kind) const { return schlupf_element_count(element_, kind); }
    std::vector<Quantity> quantities(int kind) const {
        std::vector<Quantity> all(count(kind));
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k] = {schlupf_element_name(element_, kind, k), schlupf_element_unit(element_, kind, k),
                      schlupf_element_description(element_, kind, k)};
        return all;
    }

    /** The index of a name among them. */
    std::size_t index(int kind, const std::string &name) const {
        const std::ptrdiff_t found = schlupf_element_find(element_, kind, name.c_str());
        if (found < 0) throw std::out_of_range("no such quantity: " + name);
        return static_cast<std::size_t>(found);
    }

    std::vector<double> start() const {
        std::vector<double> inputs(count(SCHLUPF_INPUTS));
        check(schlupf_element_start(element_, inputs.data(), inputs.size()));
        return inputs;
    }

    /** Room for what evaluate finds. */
    Evaluation evaluation() const {
        const std::size_t outputs = count(SCHLUPF_OUTPUTS), states = count(SCHLUPF_STATES);
        const std::size_t columns = count(SCHLUPF_INPUTS) + states;
        return {std::vector<double>(outputs), std::vector<double>(states),
                std::vector<double>((outputs + states) * columns), columns};
    }

    SchlupfStatus evaluate(const std::vector<double> &inputs, const std::vector<double> &states,
                           Evaluation &found) noexcept {
        return schlupf_element_evaluate(element_, inputs.data(), inputs.size(), states.data(),
                                        states.size(), found.outputs.data(), found.outputs.size(),
                                        found.rates.data(), found.rates.size(),
                                        found.derivatives.data(), found.derivatives.size());
    }

    SchlupfStatus advance(const std::vector<double> &inputs, std::vector<double> &states,
                          double duration) noexcept {
        return schlupf_element_advance(element_, inputs.data(), inputs.size(), states.data(),
                                       states.size(), duration);
    }

    std::string message() const { return text(schlupf_element_message); }
    /** What its method neglects, a line for each warning. */
    std::string warnings() const { return text(schlupf_element_warnings); }

private:
    Element() = default;

    std::string text(std::size_t (*of)(SchlupfElement, char *, std::size_t)) const {
        std::string copy(of(element_, nullptr, 0) + 1, '\0');
        of(element_, &copy[0], copy.size());
        copy.pop_back();
        return copy;
    }

    static std::vector<const char *> pointers(const std::vector<std::string> &texts) {
        std::vector<const char *> all;
        for (const std::string &text : texts) all.push_back(text.c_str());
        return all;
    }

    void check(SchlupfStatus status) const {
        if (status != SCHLUPF_FOUND) throw Error(status, message());
    }
    SchlupfElement element_ = 0;
};

}  // namespace schlupf

#endif
