#include "core/presentation/simulators/controller_coupling.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "core/foundations/files/json_writer.h"
#include "core/presentation/simulators/modelica.h"
#include "core/presentation/simulators/xml_text.h"

namespace geargraph {
namespace {

using CouplingRow = std::vector<Rational>;
using CouplingRows = std::vector<CouplingRow>;

CouplingRows rowsOf(const std::vector<Rational>& entries, int size) {
  CouplingRows rows;
  for (int row = 0; row < size; ++row) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(row) * size;
    rows.emplace_back(begin, begin + size);
  }
  return rows;
}

CouplingRows transposed(const CouplingRows& rows) {
  CouplingRows result(rows.size(), CouplingRow(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) result[j][i] = rows[i][j];
  }
  return result;
}

CouplingRow product(const CouplingRows& rows, const CouplingRow& values) {
  CouplingRow result;
  for (const CouplingRow& row : rows) {
    Rational sum;
    for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * values[i];
    result.push_back(sum);
  }
  return result;
}

/// All that the files hold, in fractions.
class CouplingData {
 public:
  CouplingData(const Mechanism& ofMechanism, const JointCoupling& ofMotors)
      : mechanism(ofMechanism),
        coupling(ofMotors),
        motorToJoint(rowsOf(coupling.motorToJoint, coupling.size())),
        jointToMotor(rowsOf(coupling.jointToMotor, coupling.size())),
        motorTorques(transposed(motorToJoint)),
        jointTorques(transposed(jointToMotor)) {
    // Any numbers do that are not alike.
    for (int i = 0; i < coupling.size(); ++i) {
      testMotorRates.emplace_back(i + 1);
      testJointTorques.emplace_back(i % 2 == 0 ? i + 1 : -(i + 1));
    }
    testJointRates = product(motorToJoint, testMotorRates);
    testMotorTorques = product(motorTorques, testJointTorques);
    for (int i = 0; i < coupling.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      testPower += testMotorRates[at] * testMotorTorques[at];
    }
  }

  [[nodiscard]] int labelOf(JointOrdinal joint) const { return mechanism.jointLabel(joint); }
  [[nodiscard]] const TurningJoint& at(JointOrdinal joint) const {
    return mechanism.turningJoints[static_cast<std::size_t>(static_cast<int>(joint))];
  }
  /// "joint 10, link 1 relative to link 0"
  [[nodiscard]] std::string wordsOf(JointOrdinal joint) const {
    const TurningJoint& own = at(joint);
    const auto label = [&](const LinkId& link) {
      return std::to_string(
          mechanism.linkLabel(static_cast<int>(mechanism.find(link) - mechanism.links.data())));
    };
    return "joint " + std::to_string(labelOf(joint)) + ", link " + label(own.head) + " relative to link " +
           label(own.tail);
  }

  const Mechanism& mechanism;
  const JointCoupling& coupling;
  CouplingRows motorToJoint, jointToMotor;  ///< of speeds and angles
  CouplingRows motorTorques, jointTorques;  ///< from joints to motors, and back
  CouplingRow testMotorRates, testJointRates, testJointTorques, testMotorTorques;
  Rational testPower;
};

std::string listedWords(const CouplingData& data, const std::vector<JointOrdinal>& joints,
                        const std::string& prefix) {
  std::string text;
  for (const JointOrdinal joint : joints) text += prefix + data.wordsOf(joint) + '\n';
  return text;
}

// ---- JSON ----

class CouplingJsonWriter {
 public:
  CouplingJsonWriter(const CouplingData& data, ByteSink& sink) : m_data(data), m_json(sink) {}

  void write() {
    m_json.beginObject();
    m_json.member("format", "geargraph-coupling");
    m_json.member("version", 1);
    m_json.member("name", m_data.mechanism.name);
    joints("motors", m_data.coupling.motors);
    joints("joints", m_data.coupling.joints);
    matrix("motorToJoint", m_data.motorToJoint);
    matrix("jointToMotor", m_data.jointToMotor);
    matrix("jointToMotorTorque", m_data.motorTorques);
    matrix("motorToJointTorque", m_data.jointTorques);
    limits();
    m_json.key("test");
    m_json.beginObject();
    row("motorRates", m_data.testMotorRates);
    row("jointRates", m_data.testJointRates);
    row("jointTorques", m_data.testJointTorques);
    row("motorTorques", m_data.testMotorTorques);
    m_json.member("power", m_data.testPower.toString());
    m_json.endObject();
    m_json.endObject();
  }

 private:
  void joints(std::string_view name, const std::vector<JointOrdinal>& joints) {
    m_json.key(name);
    m_json.beginArray();
    for (const JointOrdinal joint : joints) {
      const TurningJoint& own = m_data.at(joint);
      m_json.beginObject(JsonWriter::Layout::row);
      m_json.member("id", own.id.text());
      m_json.member("label", m_data.labelOf(joint));
      m_json.member("tail", own.tail.text());
      m_json.member("head", own.head.text());
      m_json.endObject();
    }
    m_json.endArray();
  }
  void values(const CouplingRow& values) {
    m_json.beginArray(JsonWriter::Layout::row);
    for (const Rational& each : values) m_json.string(each.toString());
    m_json.endArray();
  }
  void row(std::string_view name, const CouplingRow& of) {
    m_json.key(name);
    values(of);
  }
  void matrix(std::string_view name, const CouplingRows& rows) {
    m_json.key(name);
    m_json.beginArray();
    for (const CouplingRow& each : rows) values(each);
    m_json.endArray();
  }
  void end(std::string_view name, const std::optional<Rational>& value) {
    m_json.key(name);
    if (value) {
      m_json.string(value->toString());
    } else {
      m_json.null();
    }
  }
  void range(const std::optional<Rational>& low, const std::optional<Rational>& high) {
    m_json.beginObject(JsonWriter::Layout::row);
    end("low", low);
    end("high", high);
    m_json.endObject();
  }

  /// In degrees from the reference pose. A motor's range alone is wider than what it may do while the others
  /// stand anywhere: that is what the corners bound.
  void limits() {
    const std::vector<JointOrdinal>& joints = m_data.coupling.joints;
    std::vector<std::optional<Rational>> lows, highs;
    for (const JointOrdinal joint : joints) {
      const JointLimits& own = m_data.at(joint).limits;
      lows.push_back(own.low ? std::optional(own.low->exact()) : std::nullopt);
      highs.push_back(own.high ? std::optional(own.high->exact()) : std::nullopt);
    }
    m_json.key("limits");
    m_json.beginObject();
    m_json.member("unit", "deg");
    m_json.key("joints");
    m_json.beginArray();
    for (std::size_t i = 0; i < joints.size(); ++i) range(lows[i], highs[i]);
    m_json.endArray();
    m_json.key("motors");
    m_json.beginArray();
    for (const CouplingRow& gains : m_data.jointToMotor) {
      range(boundOf(gains, lows, highs), boundOf(gains, highs, lows));
    }
    m_json.endArray();
    m_json.key("corners");
    corners(lows, highs);
    m_json.endObject();
  }
  /// The sum of gains times the first bounds where they are positive, the second where they are negative.
  static std::optional<Rational> boundOf(const CouplingRow& gains,
                                         const std::vector<std::optional<Rational>>& positive,
                                         const std::vector<std::optional<Rational>>& negative) {
    Rational sum;
    for (std::size_t i = 0; i < gains.size(); ++i) {
      if (gains[i].isZero()) continue;
      const std::optional<Rational>& bound = gains[i].sign() > 0 ? positive[i] : negative[i];
      if (!bound) return std::nullopt;
      sum += gains[i] * *bound;
    }
    return sum;
  }
  /// Angles of the motors at the corners of the joints' ranges; null where a range is open or they are many.
  void corners(const std::vector<std::optional<Rational>>& lows,
               const std::vector<std::optional<Rational>>& highs) {
    const auto isOpen = [](const std::optional<Rational>& each) { return !each; };
    const std::size_t size = lows.size();
    if (size >= 8 || (1 << size) > kMaxCouplingCorners || std::any_of(lows.begin(), lows.end(), isOpen) ||
        std::any_of(highs.begin(), highs.end(), isOpen)) {
      m_json.null();
      return;
    }
    m_json.beginArray();
    for (unsigned corner = 0; corner < (1U << size); ++corner) {
      CouplingRow angles;
      for (std::size_t i = 0; i < size; ++i) angles.push_back((corner >> i) & 1U ? *highs[i] : *lows[i]);
      values(product(m_data.jointToMotor, angles));
    }
    m_json.endArray();
  }

  const CouplingData& m_data;
  JsonWriter m_json;
};

// ---- C++ and Python ----

/// "-1.0 / 2", so that the compiler divides once and the fraction can be read.
std::string quotientText(const Rational& value) {
  std::string text = value.toString();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return text + ".0";
  return text.substr(0, slash) + ".0 / " + text.substr(slash + 1) + ".0";
}

std::string arrayOf(const CouplingRow& values, const std::function<std::string(const Rational&)>& shown) {
  std::string text;
  for (const Rational& each : values) text += (text.empty() ? "" : ", ") + shown(each);
  return text;
}

std::string headerMatrix(const std::string& name, const CouplingRows& rows, const std::string& meaning) {
  std::string text = "/// " + meaning + "\nconstexpr Matrix " + name + "{{\n";
  for (const CouplingRow& row : rows) text += "    {{" + arrayOf(row, quotientText) + "}},\n";
  return text + "}};\n";
}

std::string pythonMatrix(const std::string& name, const CouplingRows& rows, const std::string& meaning) {
  const auto fraction = [](const Rational& value) { return "F(\"" + value.toString() + "\")"; };
  std::string text = "# " + meaning + '\n' + name + " = (\n";
  for (const CouplingRow& row : rows) text += "    (" + arrayOf(row, fraction) + ",),\n";
  return text + ")\n";
}

/// A name in small letters for a namespace.
std::string smallName(std::string_view name) {
  std::string text = modelicaName(name);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

constexpr std::string_view kRatesMeaning = "Rates (and angles from the reference pose) of joints: ";

// ---- ros2_control ----

/// Joints and motors that only have to do with each other, as places in the coupling.
struct CouplingBlock {
  std::vector<std::size_t> joints;
  std::vector<std::size_t> motors;
};

std::vector<CouplingBlock> blocksOf(const CouplingRows& motorToJoint) {
  const std::size_t size = motorToJoint.size();
  std::vector<CouplingBlock> blocks;
  std::vector<char> isTaken(size, 0);  // joints
  for (std::size_t first = 0; first < size; ++first) {
    if (isTaken[first]) continue;
    std::vector<char> hasMotor(size, 0);
    std::vector<std::size_t> open{first};
    isTaken[first] = 1;
    CouplingBlock block;
    while (!open.empty()) {
      const std::size_t joint = open.back();
      open.pop_back();
      block.joints.push_back(joint);
      for (std::size_t motor = 0; motor < size; ++motor) {
        if (motorToJoint[joint][motor].isZero() || hasMotor[motor]) continue;
        hasMotor[motor] = 1;
        block.motors.push_back(motor);
        for (std::size_t other = 0; other < size; ++other) {
          if (isTaken[other] || motorToJoint[other][motor].isZero()) continue;
          isTaken[other] = 1;
          open.push_back(other);
        }
      }
    }
    std::sort(block.joints.begin(), block.joints.end());
    std::sort(block.motors.begin(), block.motors.end());
    blocks.push_back(std::move(block));
  }
  return blocks;
}

class TransmissionWriter {
 public:
  explicit TransmissionWriter(const CouplingData& data) : m_data(data) {}

  std::string write() {
    m_text = "<?xml version=\"1.0\"?>\n" + xmlComment("Written by GearGraph, for ros2_control.") + '\n' +
             xmlComment(
                 "Angles count from the reference pose: set the offset of a joint where its zero differs.") +
             "\n<ros2_control" + xmlAttribute("name", m_data.mechanism.name) + " type=\"system\">\n";
    for (const CouplingBlock& block : blocksOf(m_data.motorToJoint)) transmission(block);
    return m_text + "</ros2_control>\n";
  }

 private:
  [[nodiscard]] const Rational& entry(std::size_t joint, std::size_t motor) const {
    return m_data.motorToJoint[joint][motor];
  }
  void transmission(const CouplingBlock& block) {
    ++m_count;
    m_text += "  <transmission" + xmlAttribute("name", "transmission_" + std::to_string(m_count)) + ">\n";
    if (block.joints.size() == 1) {
      plugin("transmission_interface/SimpleTransmission");
      end("actuator", block.motors[0], {}, entry(block.joints[0], block.motors[0]).inverse());
      end("joint", block.joints[0], {}, Rational(1));
    } else if (block.joints.size() != 2 || (!differential(block) && !fourBar(block))) {
      general(block);
    }
    m_text += "  </transmission>\n";
  }
  void plugin(std::string_view name) { m_text += "    <plugin>" + std::string(name) + "</plugin>\n"; }
  void end(const std::string& kind, std::size_t place, const std::string& role, const Rational& reduction) {
    const JointOrdinal joint =
        kind == "joint" ? m_data.coupling.joints[place] : m_data.coupling.motors[place];
    const std::string prefix = kind == "joint" ? "joint_" : "motor_";
    m_text += "    <" + kind + xmlAttribute("name", prefix + std::to_string(m_data.labelOf(joint))) +
              (role.empty() ? std::string() : xmlAttribute("role", role)) +
              ">\n      <mechanical_reduction>" + xmlNumber(reduction.toDouble()) +
              "</mechanical_reduction>" +
              (reduction.isInteger() ? std::string() : ' ' + xmlComment(reduction.toString())) + "\n    </" +
              kind + ">\n";
  }
  void ends(const std::vector<std::size_t>& motors, const std::vector<std::size_t>& joints,
            const std::vector<Rational>& motorReductions, const std::vector<Rational>& jointReductions) {
    for (std::size_t i = 0; i < 2; ++i)
      end("actuator", motors[i], "actuator" + std::to_string(i + 1), motorReductions[i]);
    for (std::size_t i = 0; i < 2; ++i)
      end("joint", joints[i], "joint" + std::to_string(i + 1), jointReductions[i]);
  }
  /// joint 1 = (a1/r1 + a2/r2) / 2, joint 2 = (a1/r1 - a2/r2) / (2 s)
  bool differential(const CouplingBlock& block) {
    const auto [p, q] = std::pair(block.joints[0], block.joints[1]);
    const auto [u, v] = std::pair(block.motors[0], block.motors[1]);
    const Rational &a = entry(p, u), &b = entry(p, v), &c = entry(q, u), &d = entry(q, v);
    if (a.isZero() || b.isZero() || c.isZero() || d.isZero() || a * d != -(b * c)) return false;
    plugin("transmission_interface/DifferentialTransmission");
    ends(block.motors, block.joints, {(a + a).inverse(), (b + b).inverse()}, {Rational(1), a / c});
    return true;
  }
  /// joint 1 = a1/r1, joint 2 = (a2/r2 - a1/r1) / s, in the order in which it fits
  bool fourBar(const CouplingBlock& block) {
    for (const bool turnsJoints : {false, true}) {
      for (const bool turnsMotors : {false, true}) {
        std::vector<std::size_t> joints = block.joints, motors = block.motors;
        if (turnsJoints) std::swap(joints[0], joints[1]);
        if (turnsMotors) std::swap(motors[0], motors[1]);
        const Rational &a = entry(joints[0], motors[0]), &c = entry(joints[1], motors[0]),
                       &d = entry(joints[1], motors[1]);
        if (!entry(joints[0], motors[1]).isZero() || a.isZero() || c.isZero() || d.isZero()) continue;
        const Rational lower = -(a / c);
        plugin("transmission_interface/FourBarLinkageTransmission");
        ends(motors, joints, {a.inverse(), (d * lower).inverse()}, {Rational(1), lower});
        return true;
      }
    }
    return false;
  }
  void general(const CouplingBlock& block) {
    m_text += "    " +
              xmlComment(
                  "ros2_control has no plugin for this coupling. Name your own; the header and the module "
                  "of this export hold what it has to do.") +
              '\n';
    plugin("your_package/LinearTransmission");
    for (const std::size_t motor : block.motors) end("actuator", motor, {}, Rational(1));
    for (const std::size_t joint : block.joints) end("joint", joint, {}, Rational(1));
    std::string matrix;
    for (const std::size_t joint : block.joints) {
      for (const std::size_t motor : block.motors)
        matrix += (matrix.empty() ? "" : " ") + xmlNumber(entry(joint, motor).toDouble());
    }
    m_text += "    <param name=\"actuator_to_joint\">" + matrix + "</param>\n";
  }

  const CouplingData& m_data;
  std::string m_text;
  int m_count = 0;
};

}  // namespace

std::string couplingJson(const Mechanism& mechanism, const JointCoupling& coupling) {
  const CouplingData data(mechanism, coupling);
  TextSink sink;
  CouplingJsonWriter(data, sink).write();  // complete when the writer is gone
  return sink.take();
}

std::string couplingHeader(const Mechanism& mechanism, const JointCoupling& coupling) {
  const CouplingData data(mechanism, coupling);
  const std::string size = std::to_string(coupling.size());
  std::string text =
      "// Written by GearGraph. Rates in rad/s, angles in rad from the reference pose, torques in N m.\n"
      "// Without losses. Signs are those of the joints of the document.\n//\n// Motors:\n" +
      listedWords(data, coupling.motors, "//   ") + "// Joints:\n" +
      listedWords(data, coupling.joints, "//   ") +
      "#pragma once\n\n#include <array>\n#include <cstddef>\n\nnamespace " + smallName(mechanism.name) +
      "_coupling {\n\nusing Vector = std::array<double, " + size + ">;\nusing Matrix = std::array<Vector, " +
      size + ">;\n\n" +
      headerMatrix("kMotorToJoint", data.motorToJoint,
                   std::string(kRatesMeaning) + "kMotorToJoint * motors") +
      headerMatrix("kJointToMotor", data.jointToMotor, "The inverse.") +
      headerMatrix("kJointToMotorTorque", data.motorTorques,
                   "Torques of motors that balance those of joints: the transpose of kMotorToJoint.") +
      headerMatrix("kMotorToJointTorque", data.jointTorques, "The inverse: the transpose of kJointToMotor.") +
      "\nconstexpr Vector product(const Matrix& matrix, const Vector& values) {\n  Vector result{};\n"
      "  for (std::size_t i = 0; i < values.size(); ++i) {\n"
      "    for (std::size_t j = 0; j < values.size(); ++j) result[i] += matrix[i][j] * values[j];\n  }\n"
      "  return result;\n}\n\n"
      "/// Is the power that goes in the power that comes out, and is each matrix the inverse of the other?\n"
      "constexpr bool selfTest() {\n  constexpr Vector motorRates{" +
      arrayOf(data.testMotorRates, quotientText) + "};\n  constexpr Vector jointTorques{" +
      arrayOf(data.testJointTorques, quotientText) +
      "};\n  constexpr Vector jointRates = product(kMotorToJoint, motorRates);\n"
      "  constexpr Vector motorTorques = product(kJointToMotorTorque, jointTorques);\n"
      "  constexpr Vector again = product(kJointToMotor, jointRates);\n"
      "  double in = 0, out = 0, difference = 0, size = 0;\n"
      "  for (std::size_t i = 0; i < motorRates.size(); ++i) {\n"
      "    in += motorRates[i] * motorTorques[i];\n    out += jointRates[i] * jointTorques[i];\n"
      "    const double off = again[i] - motorRates[i];\n    difference += off * off;\n"
      "    size += motorRates[i] * motorRates[i];\n  }\n"
      "  const double lost = in - out;\n"
      "  return lost * lost <= 1e-18 * (1 + in * in) && difference <= 1e-18 * size;\n}\n"
      "static_assert(selfTest());\n\n}  // namespace " +
      smallName(mechanism.name) + "_coupling\n";
  return text;
}

std::string couplingPython(const Mechanism& mechanism, const JointCoupling& coupling) {
  const CouplingData data(mechanism, coupling);
  const auto fraction = [](const Rational& value) { return "F(\"" + value.toString() + "\")"; };
  return "\"\"\"Written by GearGraph. Rates in rad/s, angles in rad from the reference pose, torques in N "
         "m.\n\n"
         "Without losses. Signs are those of the joints of the document.\n\nMotors:\n" +
         listedWords(data, coupling.motors, "  ") + "Joints:\n" + listedWords(data, coupling.joints, "  ") +
         "\"\"\"\n\nfrom fractions import Fraction as F\n\n" +
         pythonMatrix("MOTOR_TO_JOINT", data.motorToJoint,
                      std::string(kRatesMeaning) + "MOTOR_TO_JOINT times motors.") +
         pythonMatrix("JOINT_TO_MOTOR", data.jointToMotor, "The inverse.") +
         pythonMatrix("JOINT_TO_MOTOR_TORQUE", data.motorTorques,
                      "Torques of motors that balance those of joints: the transpose of MOTOR_TO_JOINT.") +
         pythonMatrix("MOTOR_TO_JOINT_TORQUE", data.jointTorques,
                      "The inverse: the transpose of JOINT_TO_MOTOR.") +
         "\n\ndef product(matrix, values):\n"
         "    return tuple(sum(a * x for a, x in zip(row, values)) for row in matrix)\n\n\n"
         "def self_test():\n"
         "    \"\"\"The power that goes in comes out, and each matrix is the inverse of the other.\"\"\"\n"
         "    motor_rates = (" +
         arrayOf(data.testMotorRates, fraction) + ",)\n    joint_torques = (" +
         arrayOf(data.testJointTorques, fraction) +
         ",)\n"
         "    joint_rates = product(MOTOR_TO_JOINT, motor_rates)\n"
         "    motor_torques = product(JOINT_TO_MOTOR_TORQUE, joint_torques)\n"
         "    assert product(JOINT_TO_MOTOR, joint_rates) == motor_rates\n"
         "    assert product(MOTOR_TO_JOINT_TORQUE, motor_torques) == joint_torques\n"
         "    power_in = sum(w * m for w, m in zip(motor_rates, motor_torques))\n"
         "    power_out = sum(w * m for w, m in zip(joint_rates, joint_torques))\n"
         "    assert power_in == power_out\n    return power_in\n\n\n"
         "if __name__ == \"__main__\":\n    print(\"power in = power out =\", self_test())\n";
}

std::string couplingTransmissions(const Mechanism& mechanism, const JointCoupling& coupling) {
  const CouplingData data(mechanism, coupling);
  return TransmissionWriter(data).write();
}

}  // namespace geargraph
